// How costs change from level to level of quality: guessed at first, then learned.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace amalgam::frame {

class RelativeCosts {
 public:
  // By level, the best first; of any unit, above 0 and never rising.
  explicit RelativeCosts(std::vector<double> costs) : costs_(std::move(costs)) {}

  // Cost of one level as a multiple of another's.
  double ratio(std::size_t to, std::size_t from) const { return costs_[to] / costs_[from]; }

  // A change of level changed the cost to so many times what it was. Levels between share the
  // correction, those beyond take it over whole.
  void learn(std::size_t from, std::size_t to, double ratio);

 private:
  std::vector<double> costs_;
};

}  // namespace amalgam::frame
