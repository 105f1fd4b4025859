// One TCP connection to a server, from connecting to its end. Connection handles reconnecting.
//
// Used only on the thread that runs its io_context. Answers pings itself. Network loss is a normal
// end: every end calls Events::ended exactly once.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
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
};

class Link : public std::enable_shared_from_this<Link> {
 public:
  struct Events {
    std::function<void(protocol::Welcome)> welcomed;
    std::function<void(protocol::Composite)> composite;
    std::function<void(protocol::Error)> error;  // errors that the session survives
    std::function<void()> idle;                  // no write in flight: ready for a frame
    std::function<void(LinkEnd)> ended;
  };

  // tls: null for a server that does not encrypt.
  Link(boost::asio::io_context& io, protocol::Stream::Tls tls, Events events);

  // Connects, says hello and waits for the welcome, all within the time-out.
  void open(const common::HostPort& server, const protocol::Hello& hello,
            std::chrono::milliseconds timeout);

  // True if a frame may be written now: welcomed, not draining, no write in flight.
  bool is_idle() const { return state_ == State::Running && writing_.empty(); }
  void write_frame(std::string bytes);
  // An encoded Envelope to be sent before any frame.
  void write_first(std::string bytes);

  // Says goodbye and waits a little for the server to close.
  void close();

 private:
  using ErrorCode = boost::system::error_code;
  enum class State { Connecting, AwaitingWelcome, Running, Draining, Closing, Ended };

  void secure();
  void say_hello();
  void connect(const boost::asio::ip::tcp::resolver::results_type& endpoints);
  void read();
  void take(std::span<const std::byte> input);
  void visit(protocol::Envelope& envelope);
  void refuse_kind();
  void on_error(protocol::Error& error);
  void send_control(const protocol::Envelope& envelope);
  void write(std::string bytes);
  void write_next();
  void expect_within(std::chrono::milliseconds time, std::string what);
  void fail(const ErrorCode& ec, const char* what);
  void end(LinkEnd::Kind kind, std::string text, std::chrono::milliseconds retry_after = {});

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
};

}  // namespace amalgam::client
