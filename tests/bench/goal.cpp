#include "bench/goal.h"

#include <stdexcept>

namespace amalgam::bench {

bool holds(double value, Comparison comparison, double bound) {
  switch (comparison) {
    case Comparison::AtLeast:
      return value >= bound;
    case Comparison::AtMost:
      return value <= bound;
    case Comparison::Below:
      return value < bound;
  }
  throw std::logic_error("a comparison that is none");
}

Verdict verdict(const GoalLine& line) {
  const auto* measured = std::get_if<Measurement>(&line.outcome);
  if (measured == nullptr) return Verdict::NotMeasured;
  if (measured->broken_condition) return Verdict::NotMet;
  return holds(measured->value, line.goal.comparison, line.goal.bound) ? Verdict::Met
                                                                       : Verdict::NotMet;
}

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::Met:
      return "met";
    case Verdict::NotMet:
      return "not met";
    case Verdict::NotMeasured:
      return "not measured";
  }
  throw std::logic_error("a verdict that is none");
}

const char* to_string(Comparison comparison) {
  switch (comparison) {
    case Comparison::AtLeast:
      return ">=";
    case Comparison::AtMost:
      return "<=";
    case Comparison::Below:
      return "<";
  }
  throw std::logic_error("a comparison that is none");
}

}  // namespace amalgam::bench
