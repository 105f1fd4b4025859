// The connection that carries one client's conversation: reads and frames bytes, has one write in
// flight and two composites unread at most, keeps the deadlines, and lingers at the end so that the
// last words arrive. Runs on the network thread.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "net/back_off.h"
#include "net/connection_limits.h"
#include "net/conversation.h"
#include "net/deadlines.h"
#include "net/read_pings.h"
#include "net/transport.h"
#include "net/write_slot.h"
#include "protocol/framing.h"

namespace amalgam::net {

class Connection : public std::enable_shared_from_this<Connection>, private Line {
 public:
  // What the server has for its connections. Outlives them.
  struct Shared {
    ServerContext& context;
    ConnectionLimits& limits;
    BackOff& back_off;
  };
  // Called exactly once, at the end.
  using OnEnd = std::function<void(std::uint64_t id)>;

  // by_proxy: a trusted proxy's, which first says in a PROXY header whom it speaks for.
  Connection(std::unique_ptr<Transport> transport, ConnectionLimits::Ticket ticket, bool by_proxy,
             std::uint64_t id, Shared& shared, OnEnd on_end);

  void start();
  // Accepts no more frames, answers those in flight, then ends.
  void drain(std::chrono::milliseconds deadline);
  // Ends at once.
  void end();
  SessionReport report() const;
  std::shared_ptr<const frame::Bytes> picture() const { return conversation_.picture(); }
  void forget_picture() { conversation_.forget_picture(); }

 private:
  using Clock = std::chrono::steady_clock;
  using ErrorCode = boost::system::error_code;
  enum class State { Open, Closing, Ended };  // in this order only

  // The conversation's line.
  void send(const protocol::Envelope& message) override;
  bool send_answer(Answer answer) override;
  void send_last(const protocol::Envelope& message) override;
  void welcomed() override;
  void refused() override;
  void heard_pong(std::uint64_t nonce) override;
  void close() override;
  std::function<void(Step)> posting() override;

  void read_proxy_header();
  void on_proxy_bytes(const ErrorCode& failed);
  void wait_for_proxy();
  bool is_admitted(const boost::asio::ip::tcp::endpoint& client);
  void open();
  void on_opened(const ErrorCode& ec, Transport::Opened opened);
  void read();
  void on_read(const ErrorCode& ec, const Transport::Received& received);
  void take(std::span<const std::byte> input, const Transport::Received& received);

  void write();
  void append_ping();
  void on_written(const ErrorCode& ec, std::size_t size);
  void finish_sending();
  void close_if_drained();

  void wait();
  void on_time(const ErrorCode& ec);
  void on_passed(Deadlines::Passed passed);

  template <typename F>
  void guarded(F step);
  void fail(protocol::Error::Code code, const std::string& text) {
    conversation_.answer(ClientError(code, text));
  }
  void lost(const ErrorCode& ec, const char* what);

  std::unique_ptr<Transport> transport_;
  boost::asio::steady_timer timer_, proxy_timer_{timer_.get_executor()};
  std::optional<ConnectionLimits::Ticket> ticket_;
  const bool by_proxy_;
  bool opened_;  // Envelopes can be written
  Shared& shared_;
  ServerContext& context_;
  std::uint64_t id_;
  OnEnd on_end_;

  State state_ = State::Open;
  bool welcomed_ = false;
  Deadlines deadlines_;
  Clock::time_point linger_end_{};
  ReadPings pings_;

  std::vector<std::byte> read_buffer_;
  protocol::Decoder decoder_;
  WriteSlot slot_;
  std::string writing_;

  Conversation conversation_;  // last: ends first, and says so to the renderer
};

}  // namespace amalgam::net
