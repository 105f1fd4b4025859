// One goal of the bench: a ratio, what it is compared with, and what came of measuring it.
//
// Goals are ratios of two things measured in one run, by turns, so that they hold on a noisy or
// shared machine as well.
#pragma once

#include <optional>
#include <string>
#include <variant>

namespace amalgam::bench {

enum class Comparison { AtLeast, AtMost, Below };

struct Goal {
  std::string name;  // "trace-threads": for --only
  std::string what;  // the ratio in words: "this / that"
  Comparison comparison = Comparison::AtLeast;
  double bound = 0.0;
  std::string unit;  // empty for a ratio
};

// low and high: the spread over the rounds, or over the rows of a table.
struct Measurement {
  double value = 0.0;
  double low = 0.0, high = 0.0;
  std::string note;  // how it was measured, in short
  // A condition beside the ratio did not hold (bytes that changed, pictures too far apart): the
  // goal is not met, whatever the ratio.
  std::optional<std::string> broken_condition{};
};

struct NotMeasured {
  std::string reason;
  bool failed = false;  // something went wrong, rather than being absent
};

using Outcome = std::variant<Measurement, NotMeasured>;

enum class Verdict { Met, NotMet, NotMeasured };

struct GoalLine {
  Goal goal;
  Outcome outcome;
};

// NaN meets nothing.
bool holds(double value, Comparison comparison, double bound);
Verdict verdict(const GoalLine& line);

const char* to_string(Verdict verdict);        // "met", "not met", "not measured"
const char* to_string(Comparison comparison);  // ">=", "<=", "<"

}  // namespace amalgam::bench
