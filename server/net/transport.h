// How a connection's Envelopes travel: over TCP as they are, or over WebSocket. Everything above it
// (deadlines, limits, the write slot, the conversation) is the same. Runs on the network thread.
#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstddef>
#include <functional>
#include <optional>

#include "protocol/framing.h"

namespace amalgam::net {

class Transport {
 public:
  using ErrorCode = boost::system::error_code;

  // Nothing: the peer did not want a session, was answered and should be let go.
  enum class Opened { Session, Nothing };
  using OnOpened = std::function<void(const ErrorCode&, Opened)>;
  using OnServed = std::function<void()>;

  struct Received {
    std::size_t size = 0;                         // bytes in the buffer
    std::optional<protocol::Decoder::Part> part;  // nothing: bytes of a stream with lengths
    const char* defect = nullptr;                 // why no Envelope can be in it
  };
  using OnReceived = std::function<void(const ErrorCode&, const Received&)>;
  using OnSize = std::function<void(const ErrorCode&, std::size_t)>;

  virtual ~Transport() = default;

  // Whatever comes before the first Envelope. served is called whenever the peer has taken a part
  // of something else.
  virtual void open(OnOpened done, OnServed served) = 0;
  virtual void read(boost::asio::mutable_buffer buffer, OnReceived done) = 0;
  // envelopes: one or more, each with its length (protocol::encode). One write at a time.
  virtual void write(boost::asio::const_buffer envelopes, OnSize done) = 0;
  // Nothing more is written. What the peer still sends is read until it finishes too.
  virtual void finish_sending() = 0;
  // At once. Everything that waits gets an error.
  virtual void close() = 0;

  virtual boost::asio::ip::tcp::socket& socket() = 0;
  virtual bool encrypted() const = 0;
  // Whether Envelopes can be written even before open().
  virtual bool speaks_at_once() const = 0;
  virtual const char* name() const = 0;  // for people and metrics
};

}  // namespace amalgam::net
