// Cost ratios between levels of quality: estimated at first, then learned.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace amalgam::frame {

class RelativeCosts {
 public:
  // By level, the best first; in any unit, above 0 and never rising.
  explicit RelativeCosts(std::vector<double> costs) : costs_(std::move(costs)) {}

  // Cost of one level as a multiple of another's.
  double ratio(std::size_t to, std::size_t from) const { return costs_[to] / costs_[from]; }

  // ratio: the measured cost at `to` over that at `from`. Levels between the two take part of the
  // correction, levels beyond `to` all of it.
  void learn(std::size_t from, std::size_t to, double ratio);

 private:
  std::vector<double> costs_;
};

}  // namespace amalgam::frame
