// Prints what a fault test measured, beside what is promised.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace amalgam::test {

// As "row 9: evicted after 5.0 s (promised: <= 5.5 s)".
inline void print_figure(const std::string& row, const std::string& what, double value,
                         const std::string& unit, const std::string& promised) {
  std::printf("row %s: %s %.3g %s (promised: %s)\n", row.c_str(), what.c_str(), value, unit.c_str(),
              promised.c_str());
  std::fflush(stdout);
  testing::Test::RecordProperty("row_" + row, std::to_string(value) + " " + unit);
}

}  // namespace amalgam::test
