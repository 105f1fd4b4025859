// Whose frame is rendered next. Turns are shared by cost and not by frame: the view that has had
// the least of the renderer's time comes first (start-time fair queueing: Goyal, Vin & Cheng,
// SIGCOMM 1996). A frame cannot be interrupted, so a turn that is longer than another view's frame
// period costs that view frames; such long turns together get a fifth of the time while others are
// there.
//
// Independent of threads and clocks. All times are given.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

namespace amalgam::frame {

class Turns {
 public:
  using Id = std::uint64_t;
  using Time = std::chrono::steady_clock::time_point;
  using Seconds = std::chrono::duration<double>;

  static constexpr double kLongShare = 0.2;
  // Seconds. Whoever sends more often than ten times a second makes nobody's turn a long one.
  static constexpr double kShortestPeriod = 0.1;
  // A view without a frame for this long does not count for what the others get.
  static constexpr std::chrono::seconds kActive{2};
  // Of a view whose rate is not known yet.
  static constexpr double kAssumedRate = 5.0;

  void open(Id id, std::size_t pixels);
  void close(Id id) { views_.erase(id); }
  void submitted(Id id, Time now);

  // The view whose turn it is; it no longer waits. Nothing if none waits, or if it is not the time
  // of those that do.
  std::optional<Id> next(Time now);
  // When next() may have a turn that it withheld, if no frame comes before; nothing if it withheld
  // none.
  std::optional<Time> withheld_until(Time now) const;
  // The turn that next() gave is over. The view may have been closed.
  void served(Id id, Seconds cost, Time now);
  // A frame's cost where none was served yet, as measured otherwise.
  void assume_seconds_per_pixel(double seconds) { seconds_per_pixel_ = seconds; }

  // Whether next() would give a turn.
  bool any_ready(Time now) const;
  double demand(Time now) const;
  double mean_rate(Time now) const;  // frames a second of an open view
  double seconds_per_pixel() const { return seconds_per_pixel_; }
  std::optional<Time> oldest_waiting() const;

 private:
  struct View {
    std::size_t pixels = 0;
    bool waits = false;
    Time waits_since{};
    double start = 0.0;             // virtual time, seconds of the renderer
    std::optional<double> cost;     // seconds
    std::optional<double> period;   // seconds
    std::optional<Time> submitted;  // last
    int frames = 0;
  };

  double cost_of(const View& view) const;
  double rate_of(const View& view) const;
  bool is_active(const View& view, Time now) const;
  bool is_long(Id id, const View& view, Time now) const;
  bool any_short_but(Id id, Time now) const;
  bool withheld(Id id, const View& view, Time now) const;

  std::map<Id, View> views_;
  double virtual_time_ = 0.0;
  Id last_served_ = 0;
  Time long_allowed_{};
  double seconds_per_pixel_ = 0.0;
};

}  // namespace amalgam::frame
