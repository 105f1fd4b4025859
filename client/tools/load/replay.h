// Plays a recorded session against a server over one link, and compares what comes back. When what
// is sent is up to the two kinds: FastReplay and TimedReplay.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "client/link/link.h"
#include "client/tools/load/load_options.h"
#include "client/tools/load/recorded_session.h"
#include "client/tools/load/replay_comparison.h"

namespace amalgam::load {

class Replay {
 public:
  using Clock = std::chrono::steady_clock;

  // All outlive it.
  Replay(boost::asio::io_context& io, const LoadOptions& options, const RecordedSession& session,
         ReplayComparison& comparison);
  virtual ~Replay() = default;
  Replay(const Replay&) = delete;
  Replay& operator=(const Replay&) = delete;

  void start();

 protected:
  // How long a composite may take, even from a slow machine.
  static constexpr std::chrono::seconds kPatience{60};

  // The session is there.
  virtual void begin() = 0;
  // The server has answered the frame with this number.
  virtual void answered(std::uint64_t number) = 0;

  // Frames go by their numbers: clients may use an id twice.
  void send(std::uint64_t number, protocol::CameraFrame frame);
  void send(const RecordedLight& light);
  // One wait at a time; a new one ends the last.
  void wait_until(Clock::time_point time, std::function<void()> then);
  void finish();

  const RecordedSession& session() const { return session_; }
  ReplayComparison& comparison() { return comparison_; }

 private:
  void put(std::string bytes);
  void write_next();
  void on_error(const protocol::Error& error);
  void on_end(const client::LinkEnd& end);

  const LoadOptions& options_;
  const RecordedSession& session_;
  ReplayComparison& comparison_;
  boost::asio::steady_timer timer_;
  std::deque<std::string> waiting_;  // for the link
  bool over_ = false;
  std::shared_ptr<client::Link> link_;
};

}  // namespace amalgam::load
