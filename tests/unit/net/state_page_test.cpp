#include "net/state_page.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace amalgam::net {
namespace {

using nlohmann::json;

TEST(StatePage, TellsOfEachSession) {
  SessionReport session;
  session.id = 3;
  session.peer = "[::1]:4711";
  session.age = std::chrono::seconds(90);
  session.skipped = 5;
  session.skipped_by[static_cast<std::size_t>(Skip::ReplacedBeforeWrite)] = 4;
  session.skipped_by[static_cast<std::size_t>(Skip::Closed)] = 1;
  session.frames_asked_per_second = 29.5;
  session.server_ms = {.median = 11.0, .p99 = 40.0};
  session.stages = {{"trace", 8.5}, {"real depth", 0.25}};
  session.passes = {{"trace", true, ""}, {"warp", false, "no lens distortion"}};
  session.quality = {.level = 2, .lowest_level = 9, .bound = frame::FrameQuality::Bound::Trace};
  session.picture = true;
  ServerReport report;
  report.admin_pictures = true;
  report.sessions = {session, {}};
  const json state = json::parse(state_json(report));
  EXPECT_EQ(state["admin_pictures"], true);
  ASSERT_EQ(state["sessions"].size(), 2u);
  const json& said = state["sessions"][0];
  EXPECT_EQ(said["peer"], "[::1]:4711");
  EXPECT_EQ(said["age_s"], 90);
  EXPECT_EQ(said["skipped_by"], (json{{"replaced_before_render", 0},
                                      {"replaced_before_write", 4},
                                      {"refused", 0},
                                      {"draining", 0},
                                      {"closed", 1}}));
  EXPECT_EQ(said["frames_asked_per_second"], 29.5);
  EXPECT_EQ(said["server_ms_p99"], 40.0);
  EXPECT_EQ(said["stages_ms"], (json{{"trace", 8.5}, {"real depth", 0.25}}));
  EXPECT_EQ(said["passes"][0], (json{{"name", "trace"}, {"ran", true}, {"reason", ""}}));
  EXPECT_EQ(said["passes"][1]["reason"], "no lens distortion");
  EXPECT_EQ(said["quality"]["bound"], "trace");
  EXPECT_EQ(said["picture"], true);
  // What is not known yet is absent, and not 0.
  EXPECT_FALSE(state["sessions"][1].contains("server_ms_p99"));
  EXPECT_FALSE(state["sessions"][1].contains("quality"));
}

TEST(StatePage, IsJsonWhateverItTells) {
  SessionReport session;
  session.peer = "<img src=x onerror=alert(1)>\"\\\n\xff";
  session.passes = {{"a\"b", false, "\x01"}};
  ServerReport report;
  report.not_ready = "full";
  report.limits = {{"load", std::numeric_limits<double>::infinity(), 0.85},
                   {"connections", 3.0, 64.0}};
  report.sessions = {session};
  const json state = json::parse(state_json(report));
  EXPECT_EQ(state["ready"], false);
  EXPECT_EQ(state["not_ready"], "full");
  EXPECT_EQ(state["alive"], true);
  EXPECT_TRUE(state["limits"]["load"]["used"].is_null());
  EXPECT_EQ(state["limits"]["connections"], (json{{"used", 3.0}, {"most", 64.0}}));
  EXPECT_EQ(state["sessions"][0]["peer"], "<img src=x onerror=alert(1)>\"\\\n\xef\xbf\xbd");
  EXPECT_EQ(state["sessions"][0]["passes"][0]["reason"], "\x01");
  EXPECT_EQ(json::parse(state_json({}))["sessions"], json::array());
}

}  // namespace
}  // namespace amalgam::net
