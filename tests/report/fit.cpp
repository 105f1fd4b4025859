#include "report/fit.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "report/statistics.h"

namespace amalgam::report {

std::optional<Fit> fit_line(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("points need as many x as y");
  if (x.empty()) return std::nullopt;
  const double mean_x = mean(x), mean_y = mean(y);
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (!(xx > 0.0)) return std::nullopt;
  const double slope = xy / xx;
  return Fit{slope, mean_y - slope * mean_x};
}

std::optional<Fit> fit_power(std::span<const double> x, std::span<const double> y) {
  std::vector<double> log_x, kept_y;
  for (std::size_t i = 0; i < x.size() && i < y.size(); ++i) {
    if (!(x[i] > 0.0)) continue;
    log_x.push_back(std::log(x[i]));
    kept_y.push_back(y[i]);
  }
  return fit_exponential(log_x, kept_y);
}

std::optional<Fit> fit_exponential(std::span<const double> x, std::span<const double> y) {
  std::vector<double> kept_x, log_y;
  for (std::size_t i = 0; i < x.size() && i < y.size(); ++i) {
    if (!(y[i] > 0.0)) continue;
    kept_x.push_back(x[i]);
    log_y.push_back(std::log(y[i]));
  }
  return fit_line(kept_x, log_y);
}

}  // namespace amalgam::report
