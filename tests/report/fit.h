// Straight lines through measured points: how an error falls with a knob.
#pragma once

#include <optional>
#include <span>

namespace amalgam::report {

struct Fit {
  double slope = 0.0;
  double intercept = 0.0;
};

// Least squares of y over x. Nothing with fewer than two different x.
std::optional<Fit> fit_line(std::span<const double> x, std::span<const double> y);

// log y over log x: y = exp(intercept) x^slope. Points that are not positive are left out.
std::optional<Fit> fit_power(std::span<const double> x, std::span<const double> y);

// ln y over x: y = exp(intercept + slope x). Points whose y is not positive are left out.
std::optional<Fit> fit_exponential(std::span<const double> x, std::span<const double> y);

}  // namespace amalgam::report
