#include "bench/goal_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace amalgam::bench {
namespace {

GoalReport make_report() {
  GoalReport report{.cores = 2, .lines = {}, .thesis = {}};
  report.lines.push_back({{"fast", "this / that", Comparison::AtMost, 0.1, ""},
                          Measurement{0.05, 0.04, 0.06, "bunny"}});
  Measurement broken{0.05, 0.04, 0.06, "bunny"};
  broken.broken_condition = "bytes changed";
  report.lines.push_back({{"wrong", "this / that", Comparison::AtMost, 0.1, ""}, broken});
  report.lines.push_back(
      {{"memory", "each session", Comparison::AtMost, 40.0, "MB"}, NotMeasured{"no server"}});
  report.thesis.push_back(
      {.row = {ThesisScene::MirrorBunny, 9, 1280, 1024, 1, ThesisMethod::OurMethod, 2.0, "A.7"},
       .frames_per_second = 5.0,
       .adaptive = true,
       .error = 0.4,
       .adaptive_error = 0.4});
  return report;
}

TEST(GoalReport, PrintsALineForEachGoal) {
  std::ostringstream out;
  const GoalReport report = make_report();
  for (const GoalLine& line : report.lines) print_line(out, line);
  print_thesis(out, report.thesis);
  const std::string text = out.str();
  EXPECT_NE(text.find("fast                 0.05  <= 0.1      met "), std::string::npos) << text;
  EXPECT_NE(text.find("0.04 to 0.06; bunny; bytes changed"), std::string::npos) << text;
  EXPECT_NE(text.find("memory                  -  <= 40 MB    not measured"), std::string::npos)
      << text;
  EXPECT_NE(text.find("no server"), std::string::npos);
  EXPECT_NE(text.find("adaptive"), std::string::npos);
}

TEST(GoalReport, JsonSaysTheSame) {
  std::ostringstream out;
  print_json(out, make_report());
  const auto json = nlohmann::json::parse(out.str());
  EXPECT_EQ(json.at("cores"), 2);
  const auto& goals = json.at("goals");
  ASSERT_EQ(goals.size(), 3u);
  EXPECT_EQ(goals[0].at("name"), "fast");
  EXPECT_EQ(goals[0].at("ratio"), 0.05);
  EXPECT_EQ(goals[0].at("comparison"), "<=");
  EXPECT_EQ(goals[0].at("goal"), 0.1);
  EXPECT_EQ(goals[0].at("verdict"), "met");
  EXPECT_EQ(goals[1].at("verdict"), "not met");
  EXPECT_EQ(goals[1].at("broken_condition"), "bytes changed");
  EXPECT_EQ(goals[2].at("verdict"), "not measured");
  EXPECT_TRUE(goals[2].at("ratio").is_null());
  const auto& row = json.at("table_6_1").at(0);
  EXPECT_EQ(row.at("ratio"), 2.5);
  EXPECT_EQ(row.at("adaptive"), true);
  EXPECT_EQ(row.at("held_to_goal"), true);
}

}  // namespace
}  // namespace amalgam::bench
