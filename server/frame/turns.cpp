#include "frame/turns.h"

#include <algorithm>
#include <utility>

namespace amalgam::frame {
namespace {

// Follows a change within a few frames, without following each frame.
double smooth(const std::optional<double>& old, double value) {
  constexpr double kNew = 0.3;
  return old ? *old + kNew * (value - *old) : value;
}

}  // namespace

void Turns::open(Id id, std::size_t pixels) {
  View view;
  view.pixels = pixels;
  view.start = virtual_time_;
  views_.emplace(id, view);
}

void Turns::submitted(Id id, Time now) {
  const auto found = views_.find(id);
  if (found == views_.end()) return;
  View& view = found->second;
  if (view.submitted) {
    // After a pause the rate is what it was, not one frame a pause.
    const double period = Seconds(now - *view.submitted).count();
    if (period < Seconds(kActive).count()) view.period = smooth(view.period, period);
  }
  view.submitted = now;
  ++view.frames;
  if (std::exchange(view.waits, true)) return;
  view.waits_since = now;
  // Who was away has saved nothing up.
  view.start = std::max(view.start, virtual_time_);
}

std::optional<Turns::Id> Turns::next(Time now) {
  // Among equals they go round.
  const auto order = [&](Id id, const View& view) {
    return std::make_pair(view.start, id > last_served_ ? 0 : 1);
  };
  auto best = views_.end();
  for (auto entry = views_.begin(); entry != views_.end(); ++entry) {
    if (!entry->second.waits || withheld(entry->first, entry->second, now)) continue;
    if (best == views_.end() ||
        order(entry->first, entry->second) < order(best->first, best->second)) {
      best = entry;
    }
  }
  if (best == views_.end()) return std::nullopt;
  best->second.waits = false;
  // A view whose turn was withheld lies behind; the others' time goes on from where it was.
  virtual_time_ = std::max(virtual_time_, best->second.start);
  last_served_ = best->first;
  return best->first;
}

void Turns::served(Id id, Seconds cost, Time now) {
  const auto found = views_.find(id);
  if (found == views_.end()) return;
  View& view = found->second;
  view.cost = smooth(view.cost, cost.count());
  if (is_long(id, view, now)) {
    const Seconds pause = cost * (1.0 / kLongShare - 1.0);
    long_allowed_ = now + std::chrono::duration_cast<Time::duration>(pause);
  }
  view.start += cost.count();
  if (view.pixels > 0) {
    const double each = cost.count() / static_cast<double>(view.pixels);
    seconds_per_pixel_ = seconds_per_pixel_ > 0.0 ? smooth(seconds_per_pixel_, each) : each;
  }
}

double Turns::cost_of(const View& view) const {
  return view.cost.value_or(seconds_per_pixel_ * static_cast<double>(view.pixels));
}

double Turns::rate_of(const View& view) const {
  return view.period && *view.period > 0.0 ? 1.0 / *view.period : kAssumedRate;
}

bool Turns::is_active(const View& view, Time now) const {
  return view.waits || (view.submitted && now - *view.submitted < kActive);
}

// Whether its turn takes longer than another's frames are apart.
bool Turns::is_long(Id id, const View& view, Time now) const {
  const double cost = cost_of(view);
  return std::any_of(views_.begin(), views_.end(), [&](const auto& other) {
    return other.first != id && is_active(other.second, now) && other.second.period &&
           cost > std::max(*other.second.period, kShortestPeriod);
  });
}

bool Turns::any_short_but(Id id, Time now) const {
  return std::any_of(views_.begin(), views_.end(), [&](const auto& other) {
    return other.first != id && is_active(other.second, now) &&
           !is_long(other.first, other.second, now);
  });
}

bool Turns::withheld(Id id, const View& view, Time now) const {
  return now < long_allowed_ && is_long(id, view, now) && any_short_but(id, now);
}

std::optional<Turns::Time> Turns::withheld_until(Time now) const {
  const bool any = std::any_of(views_.begin(), views_.end(), [&](const auto& entry) {
    return entry.second.waits && withheld(entry.first, entry.second, now);
  });
  if (!any) return std::nullopt;
  // Sooner, if those for whom it is withheld fall silent.
  Time until = long_allowed_;
  for (const auto& [id, view] : views_) {
    if (!view.waits && is_active(view, now)) until = std::min(until, *view.submitted + kActive);
  }
  return until;
}

bool Turns::any_ready(Time now) const {
  return std::any_of(views_.begin(), views_.end(), [&](const auto& entry) {
    return entry.second.waits && !withheld(entry.first, entry.second, now);
  });
}

double Turns::demand(Time now) const {
  double sum = 0.0;
  for (const auto& [id, view] : views_) {
    // One that was only just opened will send frames.
    const bool counts = is_active(view, now) || view.frames == 0;
    if (counts) sum += rate_of(view) * cost_of(view);
  }
  return sum;
}

double Turns::mean_rate(Time now) const {
  double sum = 0.0;
  int count = 0;
  for (const auto& [id, view] : views_) {
    if (!is_active(view, now)) continue;
    sum += rate_of(view);
    ++count;
  }
  return count == 0 ? kAssumedRate : sum / count;
}

std::optional<Turns::Time> Turns::oldest_waiting() const {
  std::optional<Time> oldest;
  for (const auto& [id, view] : views_) {
    if (view.waits && (!oldest || view.waits_since < *oldest)) oldest = view.waits_since;
  }
  return oldest;
}

}  // namespace amalgam::frame
