#include "bench/series.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "core/timings.h"

namespace amalgam::bench {

double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("no median of nothing");
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

Ratio ratio_of_rounds(const std::vector<double>& above, const std::vector<double>& below) {
  if (above.size() != below.size() || above.empty()) {
    throw std::invalid_argument("a ratio needs as many measurements of one side as of the other");
  }
  std::vector<double> ratios;
  for (std::size_t i = 0; i < above.size(); ++i) ratios.push_back(above[i] / below[i]);
  return {.value = median(ratios),
          .low = *std::min_element(ratios.begin(), ratios.end()),
          .high = *std::max_element(ratios.begin(), ratios.end()),
          .above = median(above),
          .below = median(below),
          .rounds = static_cast<int>(above.size())};
}

Ratio measure_by_turns(const Rounds& rounds, const std::function<double()>& above,
                       const std::function<double()>& below) {
  const core::Stopwatch stopwatch;
  std::vector<double> a, b;
  for (int i = 0; i < rounds.most; ++i) {
    if (i >= rounds.least && stopwatch.milliseconds() > 1000.0 * rounds.seconds) break;
    a.push_back(above());
    b.push_back(below());
  }
  return ratio_of_rounds(a, b);
}

std::string describe(const Ratio& ratio, const std::string& unit) {
  char text[128];
  std::snprintf(text, sizeof text, "%.4g %s / %.4g %s, %d rounds", ratio.above, unit.c_str(),
                ratio.below, unit.c_str(), ratio.rounds);
  return text;
}

}  // namespace amalgam::bench
