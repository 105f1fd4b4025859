// One client's conversation with the server, from its socket to the renderer and back: read, check,
// submit; deliver, write. Runs on the network thread; the renderer's results are posted there.
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

#include "frame/frame.h"
#include "net/capture_clock.h"
#include "net/client_error.h"
#include "net/connection_limits.h"
#include "net/deadlines.h"
#include "net/environment_slot.h"
#include "net/frame_ledger.h"
#include "net/metrics.h"
#include "net/pose_hold.h"
#include "net/server_config.h"
#include "net/write_slot.h"
#include "protocol/framing.h"

namespace amalgam::net {

// Shared by all sessions. Outlives them.
struct SessionContext {
  const ServerConfig& config;
  frame::FrameService& service;
  Metrics& metrics;
  std::function<void(std::uint64_t session)> on_end;
};

// For /state.
struct SessionReport {
  std::uint64_t id = 0;
  std::string peer;
  std::string state;
  int width = 0, height = 0;  // pixels
  std::uint64_t received = 0, sent = 0, skipped = 0;
  std::size_t in_flight = 0;
};

class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(boost::asio::ip::tcp::socket socket, ConnectionLimits::Ticket ticket, std::uint64_t id,
          SessionContext& context);
  ~Session();

  void start();
  // Accepts no more frames, answers those in flight, then ends.
  void drain(std::chrono::milliseconds deadline);
  // Ends at once. The session calls context.on_end exactly once, here or by itself.
  void end();
  SessionReport report() const;

 private:
  using Clock = std::chrono::steady_clock;
  using ErrorCode = boost::system::error_code;
  enum class State { AwaitingHello, Running, Draining, Closing, Ended };  // in this order only

  void read();
  void on_read(const ErrorCode& ec, std::size_t size);
  void take(std::span<const std::byte> input);

  void visit(const protocol::Envelope& envelope);
  void on_hello(const protocol::Hello& hello);
  void on_camera_frame(const protocol::CameraFrame& frame);
  void on_environment(const protocol::Environment& environment);
  void apply(std::optional<frame::EnvironmentInput> environment);
  void on_ping(const protocol::Ping& ping);
  std::vector<common::MarkerPose> usable_poses(const protocol::CameraFrame& frame);

  template <typename... Args>
  std::function<void(Args...)> posting(void (Session::*handler)(Args...));
  void on_environment_applied(std::optional<std::string> error);
  void on_rendered(std::uint64_t number, frame::FrameResult result);
  void send_composite(const FrameLedger::Entry& frame, const frame::FrameOutput& output);

  void send(const protocol::Envelope& message);
  void write();
  void on_written(const ErrorCode& ec, std::size_t size);

  void wait();
  void on_time(const ErrorCode& ec);
  void on_passed(Deadlines::Passed passed);

  template <typename Step>
  void guarded(Step step);
  void answer(const ClientError& error);
  void fail(protocol::Error::Code code, const std::string& text) {
    answer(ClientError(code, text));
  }
  void lost(const ErrorCode& ec, const char* what);
  void close(std::chrono::milliseconds linger);
  void finish_sending();
  void close_if_drained();
  void leave_renderer();
  bool is_open() const { return state_ < State::Closing; }
  std::string name() const;

  boost::asio::ip::tcp::socket socket_;
  boost::asio::steady_timer timer_;
  std::optional<ConnectionLimits::Ticket> ticket_;
  std::uint64_t id_;
  std::string peer_;
  SessionContext& context_;

  State state_ = State::AwaitingHello;
  Deadlines deadlines_;
  Clock::time_point linger_end_{};

  std::vector<std::byte> read_buffer_;
  protocol::Decoder decoder_;
  WriteSlot slot_;
  std::string writing_;

  std::optional<frame::ViewId> view_;
  common::CameraModel camera_;
  PoseHold pose_hold_;
  CaptureClock capture_clock_;
  EnvironmentSlot environments_;
  FrameLedger ledger_;
  std::uint64_t pings_ = 0;
};

}  // namespace amalgam::net
