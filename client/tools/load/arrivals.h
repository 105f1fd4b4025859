// Clients that arrive at random times, however many are there: an open loop, as the world's is.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <random>

#include "client/tools/load/load_options.h"

namespace amalgam::load {

class Arrivals {
 public:
  using Clock = std::chrono::steady_clock;

  // All but begin outlive it. start_one: called with 0, 1, ... until the duration is over.
  Arrivals(boost::asio::io_context& io, const LoadOptions& options, Clock::time_point begin,
           std::function<void(int number)> start_one)
      : options_(options),
        end_(begin + options.duration),
        next_(begin),
        start_one_(std::move(start_one)),
        timer_(io) {}

  // For the next one. The times between them are exponential, so that there are any of them.
  void wait() {
    next_ += std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(std::exponential_distribution(options_.arrivals)(random_)));
    if (next_ >= end_) return;
    timer_.expires_at(next_);
    timer_.async_wait([this](const boost::system::error_code& ec) {
      if (ec) return;
      start_one_(count_++);
      wait();
    });
  }

  int count() const { return count_; }

 private:
  const LoadOptions& options_;
  Clock::time_point end_, next_;
  std::function<void(int)> start_one_;
  boost::asio::steady_timer timer_;
  std::mt19937 random_{1};  // the same whenever it is run again
  int count_ = 0;
};

}  // namespace amalgam::load
