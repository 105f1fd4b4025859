#include "report/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

namespace amalgam::report {
namespace {

constexpr int kResamples = 2000;

void check_any(std::span<const double> values) {
  if (values.empty()) throw std::invalid_argument("no statistics of nothing");
}

}  // namespace

double mean(std::span<const double> values) {
  check_any(values);
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double percentile(std::vector<double> values, double share) {
  check_any(values);
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - std::floor(place));
}

Interval bootstrap_mean(std::span<const double> values, std::uint64_t seed) {
  check_any(values);
  std::mt19937_64 random(seed);
  std::vector<double> means, drawn(values.size());
  for (int i = 0; i < kResamples; ++i) {
    // The standard's distributions differ between libraries; the generator does not. The modulus
    // prefers no value by more than 1e-16.
    for (double& value : drawn) value = values[random() % values.size()];
    means.push_back(mean(drawn));
  }
  return {percentile(means, 0.025), percentile(means, 0.975)};
}

}  // namespace amalgam::report
