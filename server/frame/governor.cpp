#include "frame/governor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace amalgam::frame {
namespace {

template <typename Level, typename Cost>
RelativeCosts costs_of(const std::vector<Level>& levels, Cost Level::*cost) {
  std::vector<double> costs;
  for (const Level& level : levels) costs.push_back(level.*cost);
  return RelativeCosts(std::move(costs));
}

// The tracing cost of a picture full of specular pixels: independent of how many are in view.
double traced_unit(const FrameCost& cost) {
  return cost.specular > 0.0 ? cost.trace / cost.specular : 0.0;
}

// Averages over about half a dozen frames, but follows a jump at once.
double smoothed(double smooth, double value) {
  constexpr double kShare = 0.2, kJump = 0.25;
  const bool jumped = std::abs(value - smooth) > kJump * smooth;
  return jumped ? value : smooth + kShare * (value - smooth);
}

}  // namespace

// A coarser JPEG is seen all over the picture and saves little.
double Governor::Choice::harm() const {
  return static_cast<double>(level) + 2.5 * static_cast<double>(jpeg);
}

Governor::Governor(double budget_ms, std::vector<QualityLevel> ladder, std::vector<JpegLevel> jpeg)
    : budget_(budget_ms),
      ladder_(std::move(ladder)),
      jpeg_(std::move(jpeg)),
      trace_(costs_of(ladder_, &QualityLevel::trace_cost)),
      raster_(costs_of(ladder_, &QualityLevel::raster_cost)),
      encode_(costs_of(jpeg_, &JpegLevel::cost)) {
  for (std::size_t level = 0; level < ladder_.size(); ++level) {
    for (std::size_t quality = 0; quality < jpeg_.size(); ++quality) {
      choices_.push_back({level, quality});
    }
  }
  std::stable_sort(choices_.begin(), choices_.end(),
                   [](const Choice& a, const Choice& b) { return a.harm() < b.harm(); });
}

FrameQuality Governor::report() const {
  const QualityLevel& level = quality();
  FrameQuality quality{.level = static_cast<int>(current_),
                       .lowest_level = static_cast<int>(choices_.size()) - 1,
                       .samples_per_pixel = level.samples_per_pixel,
                       .adaptive = level.adaptive_threshold.has_value(),
                       .max_depth = level.max_depth,
                       .importance_cutoff = level.importance_cutoff,
                       .render_scale = level.render_scale,
                       .jpeg_quality = jpeg_quality(),
                       .bound = FrameQuality::Bound::Nothing};
  using Bound = FrameQuality::Bound;
  if (current_ > 0 && next_lower(current_) == current_) {
    quality.bound = Bound::Lowest;
  } else if (current_ > 0) {
    const FrameCost better = predict(current_ - 1);
    quality.bound = Bound::Trace;
    if (better.raster > better.trace) quality.bound = Bound::Raster;
    if (better.encode > std::max(better.trace, better.raster)) quality.bound = Bound::Encode;
  }
  return quality;
}

FrameCost Governor::predict(std::size_t index) const {
  const Choice &to = choices_[index], &from = choice();
  FrameCost cost = last_;
  cost.trace *= trace_.ratio(to.level, from.level);
  cost.raster *= raster_.ratio(to.level, from.level);
  cost.encode *= encode_.ratio(to.jpeg, from.jpeg);
  return cost;
}

// A coarser JPEG is a choice only if encoding would take longest.
bool Governor::is_sensible(std::size_t index) const {
  if (choices_[index].jpeg == 0) return true;
  const FrameCost cost = predict(index);
  const double full_encode = cost.encode * encode_.ratio(0, choices_[index].jpeg);
  return full_encode >= std::max(cost.trace, cost.raster);
}

bool Governor::fits(std::size_t index, double share) const {
  return predict(index).total() <= share * budget_ && is_sensible(index);
}

// The next choice with less quality; the current one if there is none.
std::size_t Governor::next_lower(std::size_t index) const {
  for (std::size_t lower = index + 1; lower < choices_.size(); ++lower) {
    if (is_sensible(lower)) return lower;
  }
  return index;
}

void Governor::frame_done(const FrameCost& cost) {
  last_ = cost;
  // Work that quality does not change is often a single event (shadow maps are drawn, something is
  // made). It counts only if it comes twice in a row.
  last_.other = std::min(cost.other, last_other_);
  last_other_ = cost.other;
  learn(last_);
  if (last_.total() > budget_) {
    go_down();
  } else {
    consider_going_up();
  }
}

void Governor::learn(const FrameCost& cost) {
  FrameCost& smooth = stay_.smooth;
  const bool first = stay_.frames++ == 0;
  const FrameCost unit{traced_unit(cost), cost.raster, cost.encode, 0.0, 1.0};
  smooth = first
               ? unit
               : FrameCost{smoothed(smooth.trace, unit.trace), smoothed(smooth.raster, unit.raster),
                           smoothed(smooth.encode, unit.encode), 0.0, 1.0};
  if (!before_ || stay_.frames > kLearnFrames) return;
  const Choice &from = choices_[before_->choice], &to = choice();
  trace_.learn(from.level, to.level, smooth.trace / before_->smooth.trace);
  raster_.learn(from.level, to.level, smooth.raster / before_->smooth.raster);
  encode_.learn(from.jpeg, to.jpeg, smooth.encode / before_->smooth.encode);
}

void Governor::go_down() {
  calm_ = 0;
  std::size_t lower = next_lower(current_);
  while (!fits(lower, kFits) && next_lower(lower) != lower) lower = next_lower(lower);
  change_to(lower);
}

void Governor::consider_going_up() {
  std::size_t better = 0;
  while (better < current_ && !fits(better, kCalm)) ++better;
  calm_ = better < current_ ? calm_ + 1 : 0;
  if (calm_ < kCalmFrames) return;
  calm_ = 0;
  change_to(better);
}

void Governor::change_to(std::size_t index) {
  if (index == current_) return;
  before_ = stay_;
  stay_ = {.choice = index, .frames = 0, .smooth = {}};
  current_ = index;
}

}  // namespace amalgam::frame
