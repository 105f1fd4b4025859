// Rows 39 and q: what operators and their monitoring see.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <regex>
#include <vector>

#include "faults/figure.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using testing::HasSubstr;

TEST(AdminPort, SlowConnectionsDoNotKeepLivezFromAnswering) {
  TestServer server;
  std::vector<TestClient> slow;
  for (int i = 0; i < 16; ++i) {
    slow.emplace_back(server.server().admin_address());
    slow.back().send_bytes("GET /livez HTTP/1.1\r\nHost: ");
  }
  double worst = 0.0;
  for (int i = 0; i < 5; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(server.admin("/livez").status, 200);
    worst = std::max(
        worst, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  print_figure("39", "/livez beside 16 slow connections took", worst, "s", "<= 1 s");
  EXPECT_LT(worst, 1.0);
}

TEST(AdminPort, MetricsAreThereBeforeAnythingHappens) {
  TestServer server;
  const std::string text = server.admin("/metrics").body;
  for (const char* line :
       {"amalgam_refusals_total{reason=\"load\"} 0", "amalgam_refusals_total{reason=\"address\"} 0",
        "amalgam_refusals_total{reason=\"back_off\"} 0", "amalgam_connections 0",
        "amalgam_environments_total{result=\"too_often\"} 0", "amalgam_queue_age_seconds 0",
        "amalgam_build_info{", "process_cpu_seconds_total ", "process_resident_memory_bytes ",
        "process_open_fds ", "amalgam_log_lines_dropped_total 0",
        "amalgam_reloads_total{result=\"done\"} 0"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
  EXPECT_THAT(text, Not(HasSubstr("process_open_fds 0")));
  EXPECT_THAT(text, Not(HasSubstr("process_resident_memory_bytes 0")));
}

TEST(AdminPort, LabelsAreWordsAndSumsAreNoParts) {
  TestServer server;
  TestClient client = server.session();
  client.send(frame_message(1));
  client.expect(protocol::Envelope::kComposite);
  const std::string text = server.admin("/metrics").body;
  EXPECT_THAT(text, HasSubstr("amalgam_stage_seconds_count{stage=\"trace\"} 1"));
  EXPECT_THAT(text, Not(HasSubstr("stage=\"total\"")));
  const std::regex odd_label("\\{(stage|pass|bound|reason|result)=\"[^\"]*[^a-z0-9_\"][^\"]*\"");
  EXPECT_FALSE(std::regex_search(text, odd_label));
}

}  // namespace
}  // namespace amalgam::test
