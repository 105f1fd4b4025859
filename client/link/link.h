// One TCP connection to a server, from connecting to its end. Connection handles reconnecting.
//
// Used only on the thread that runs its io_context, which may run any number of links. Answers
// pings itself. Network loss is a normal end: every end calls Events::ended exactly once.
#pragma once

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/host_port.h"
#include "protocol/amalgam.pb.h"
#include "protocol/framing.h"
#include "protocol/stream.h"

namespace amalgam::client {

struct LinkEnd {
  enum class Kind {
    Lost,     // unreachable, broken, silent, or closed by the server: worth another try
    Busy,     // worth another try after retry_after
    Refused,  // by the server with an Error that another try would get again
    Closed,   // by us
  };
  Kind kind = Kind::Lost;
  std::string text;
  std::chrono::milliseconds retry_after{0};
  std::optional<protocol::Error::Code> code{};  // of the server's Error, if that was the end
};

class Link : public std::enable_shared_from_this<Link> {
 public:
  struct Events {
    std::function<void(protocol::Welcome)> welcomed;
    std::function<void(protocol::Composite)> composite;
    std::function<void(protocol::Error)> error;  // errors that the session survives
    std::function<void()> idle;                  // no write in flight: ready for a frame
    std::function<void(LinkEnd)> ended;
    // The server will answer what it has and close.
    std::function<void()> draining = [] {};
  };

  // tls: null for a server that does not encrypt.
  Link(boost::asio::io_context& io, protocol::Stream::Tls tls, Events events);

  // The machine's own address to connect from; without it the system chooses. Before open().
  void come_from(const boost::asio::ip::address& source) { source_ = source; }

  // Connects, says hello and waits for the welcome, all within the time-out.
  void open(const common::HostPort& server, const protocol::Hello& hello,
            std::chrono::milliseconds timeout);

  // True if a frame may be written now: welcomed, not draining, no write in flight.
  bool is_idle() const { return state_ == State::Running && writing_.empty(); }
  void write_frame(std::string bytes);
  // Bytes to be sent before any frame; an encoded Envelope, from clients that behave.
  void write_first(std::string bytes);

  // Says goodbye and waits a little for the server to close.
  void close();
  // Ends at once, without a goodbye.
  void cut() { end(LinkEnd::Kind::Closed, {}); }
  // Reads nothing more, and waits for nothing: as a client that hangs.
  void stop_reading();

  // So far.
  std::uint64_t bytes_sent() const { return bytes_sent_; }
  std::uint64_t bytes_received() const { return bytes_received_; }

 private:
  using ErrorCode = boost::system::error_code;
  enum class State { Connecting, AwaitingWelcome, Running, Draining, Closing, Ended };

  void secure();
  void say_hello();
  void connect(const boost::asio::ip::tcp::resolver::results_type& endpoints);
  bool bind_source();
  void on_connected(const ErrorCode& ec);
  void read();
  void on_read(const ErrorCode& ec, std::size_t size);
  void take(std::span<const std::byte> input);
  void visit(protocol::Envelope& envelope);
  void refuse_kind();
  void on_error(protocol::Error& error);
  void send_control(const protocol::Envelope& envelope);
  void write(std::string bytes);
  void write_next();
  void expect_sign_of_life();
  void expect_within(std::chrono::milliseconds time, std::string what);
  void fail(const ErrorCode& ec, const char* what);
  void end(LinkEnd end);
  void end(LinkEnd::Kind kind, std::string text) {
    end({.kind = kind, .text = std::move(text), .retry_after = {}, .code = {}});
  }

  boost::asio::ip::tcp::resolver resolver_;
  protocol::Stream::Tls tls_;
  protocol::Stream stream_;
  boost::asio::steady_timer timer_;
  Events events_;
  State state_ = State::Connecting;
  std::string host_, hello_;
  std::vector<std::byte> read_buffer_;
  protocol::Decoder decoder_;
  std::deque<std::string> control_;  // sent before frames
  std::string writing_;              // the one write in flight
  std::optional<boost::asio::ip::address> source_;
  bool reads_ = true;
  std::uint64_t bytes_sent_ = 0, bytes_received_ = 0;
};

}  // namespace amalgam::client
