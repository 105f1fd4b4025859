// The bench's answer: a line for each goal, and the rows of Table 6.1, as text or as JSON.
#pragma once

#include <iosfwd>
#include <vector>

#include "bench/goal.h"
#include "bench/thesis_result.h"

namespace amalgam::bench {

struct GoalReport {
  int cores = 0;
  std::vector<GoalLine> lines;
  std::vector<ThesisResult> thesis;  // empty: no goal asked for the table
};

// Text is printed as it comes: the head, a line for each goal, and last the rows (nothing if there
// are none).
void print_head(std::ostream& out, int cores);
void print_line(std::ostream& out, const GoalLine& line);
void print_thesis(std::ostream& out, const std::vector<ThesisResult>& results);

// One object: cores, goals, table_6_1. Numbers that were not measured are null.
void print_json(std::ostream& out, const GoalReport& report);

}  // namespace amalgam::bench
