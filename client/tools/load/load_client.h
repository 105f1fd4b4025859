// One client of the load: sends frames at its rate over one connection and counts the answers.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "client/tools/load/load_image.h"
#include "client/tools/load/load_options.h"
#include "client/tools/load/load_summary.h"
#include "protocol/framing.h"
#include "protocol/stream.h"

namespace amalgam::load {

class LoadClient : public std::enable_shared_from_this<LoadClient> {
 public:
  // All but the number outlive the client. number: 0 for the first client.
  LoadClient(boost::asio::io_context& io, const LoadOptions& options, const LoadImage& image,
             LoadSummary& summary, int number = 0);
  using Clock = std::chrono::steady_clock;
  // load_begin: from when the summary counts seconds.
  void start(Clock::time_point load_begin = Clock::now());

 private:
  using ErrorCode = boost::system::error_code;
  enum class State { Connecting, Sending, Waiting, Ended };

  void take_source_address();
  void secure();
  void say_hello();
  void read();
  void take(std::size_t size);
  void visit(const protocol::Envelope& envelope);
  void on_composite(const protocol::Composite& composite);
  void on_error(const protocol::Error& error);

  void wait_for_next_frame();
  void send_frame();
  void send_garbage();
  void send_environment();
  void say_nothing();
  std::chrono::milliseconds length() const;  // of this client's session
  protocol::Envelope next_frame();
  double marker_distance() const;  // metres
  void answered(std::uint64_t frame_id);
  void cut();
  void wait_for_answers();

  void send(const protocol::Envelope& envelope);
  void write();
  void end(bool lost);

  const LoadOptions& options_;
  const LoadImage& image_;
  LoadSummary& summary_;
  int number_;
  protocol::Stream stream_;
  boost::asio::steady_timer timer_;
  State state_ = State::Connecting;
  bool draining_ = false;
  Clock::time_point begin_{}, next_frame_{};
  struct DueFrame {
    std::uint64_t answered_by;  // this frame or a later one
    Clock::time_point due;
  };
  std::deque<DueFrame> due_;  // without an answer so far
  Clock::time_point load_begin_{};
  std::uint64_t last_frame_ = 0;
  std::uint64_t skipped_ = 0;
  int marker_ = 0;
  protocol::Decoder decoder_{protocol::limits_of_client()};
  std::vector<std::byte> buffer_;
  std::deque<std::string> queue_;  // the first one is being written
};

}  // namespace amalgam::load
