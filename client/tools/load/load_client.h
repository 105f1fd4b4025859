// One client of the load: sends frames at its rate over one connection and counts the answers.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "client/link/link.h"
#include "client/tools/load/load_image.h"
#include "client/tools/load/load_options.h"
#include "client/tools/load/load_summary.h"

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
  enum class State { Connecting, Sending, Cutting, Waiting, Ended };

  client::Link::Events events();
  std::optional<boost::asio::ip::address> source_address() const;
  protocol::Hello hello() const;
  void on_welcome(const protocol::Welcome& welcome);
  void on_composite(const protocol::Composite& composite);
  void on_error(const protocol::Error& error);
  void on_idle();
  void on_link_end(const client::LinkEnd& link_end);

  void wait_for_next_frame();
  void send_frame();
  void send_garbage();
  void send_environment();
  std::chrono::milliseconds length() const;  // of this client's session
  protocol::Envelope next_frame();
  double marker_distance() const;  // metres
  void answered(std::uint64_t frame_id);
  void wait_for_answers();
  void end(bool lost);

  boost::asio::io_context& io_;
  const LoadOptions& options_;
  const LoadImage& image_;
  LoadSummary& summary_;
  int number_;
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
  std::string waiting_;  // the frame behind the one that is being written; empty: none
  bool half_sent_ = false;
  std::shared_ptr<client::Link> link_;  // until it has ended; its events keep this client alive
};

}  // namespace amalgam::load
