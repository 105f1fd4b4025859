// amalgam-report as a user runs it, and as it is cut off.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "bench/povray/temporary_folder.h"
#include "report/runs_file.h"
#include "report/whole_file.h"
#include "support/child_process.h"

namespace amalgam::report {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;
using testing::HasSubstr;
using testing::Not;
using tests::ChildProcess;
constexpr seconds kPatience(120);

class Program : public testing::Test {
 protected:
  // One small sweep of one scene: four settings, two runs each; one renderer does.
  std::vector<std::string> small(const fs::path& output) const {
    return {"--quick",
            "--output",
            output.string(),
            "--references",
            (folder_.path() / "references").string(),
            "--only",
            "complex",
            "--sweep",
            "JPEG quality",
            "--part",
            "sweeps",
            "--size",
            "32x24",
            "--runs",
            "2"};
  }
  static int run(const std::vector<std::string>& arguments) {
    return ChildProcess("amalgam-report", arguments).wait(kPatience);
  }
  static bool has_gnuplot() { return std::system("command -v gnuplot >/dev/null") == 0; }

  bench::TemporaryFolder folder_;
  fs::path output_ = folder_.path() / "out";
};

TEST_F(Program, WritesItsThreeFiles) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not there: apt-get install gnuplot-nox";
  ASSERT_EQ(run(small(output_)), 0);
  const RunsFile runs(output_ / "runs.csv");
  EXPECT_EQ(runs.rows().size(), 8u);
  const CsvText summary = parse_csv(read_whole_file(output_ / "summary.csv"));
  EXPECT_EQ(summary.rows.size(), 5u);
  const std::string page = read_whole_file(output_ / "report.html");
  EXPECT_THAT(page, HasSubstr("<svg"));
  EXPECT_THAT(page, HasSubstr("Worst cases"));
  EXPECT_THAT(page, Not(HasSubstr("Camera jitter")));  // a part that was not asked for
  for (const auto& entry : fs::directory_iterator(output_)) {
    EXPECT_THAT(entry.path().string(), Not(HasSubstr(".part-")));
  }
}

// Killed in the middle, it loses at most the run in hand. Rows that are there are not measured
// again: their times would be others.
TEST_F(Program, GoesOnAfterAKill) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not there: apt-get install gnuplot-nox";
  const fs::path path = output_ / "runs.csv";
  const auto lines = [&] {
    std::ifstream file(path);
    return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
  };
  constexpr auto kHeadAndThree = 4;
  {
    ChildProcess process("amalgam-report", small(output_));
    const auto until = std::chrono::steady_clock::now() + kPatience;
    while (lines() < kHeadAndThree && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    process.signal(SIGKILL);
    process.wait(seconds(10));
  }
  ASSERT_GE(lines(), kHeadAndThree);
  EXPECT_FALSE(fs::exists(output_ / "report.html"));
  const std::string kept = read_whole_file(path);
  const std::string whole = kept.substr(0, parse_csv(kept).whole_size);
  // As if the kill had come in the middle of a row.
  std::ofstream(path, std::ios::binary | std::ios::app) << "half,a \"row";
  ASSERT_EQ(run(small(output_)), 0);
  EXPECT_EQ(read_whole_file(path).substr(0, whole.size()), whole);
  EXPECT_EQ(RunsFile(path).rows().size(), 8u);
  EXPECT_TRUE(fs::exists(output_ / "report.html"));
}

TEST_F(Program, RefusesBadOptions) {
  const std::string output = output_.string();
  const std::vector<std::vector<std::string>> bad{{"--quick"},
                                                  {"--output", output, "--only", "teapot"},
                                                  {"--output", output, "--sweep", "colors"},
                                                  {"--output", output, "--part", "everything"},
                                                  {"--output", output, "--size", "32"},
                                                  {"--output", output, "--size", "32x24x"},
                                                  {"--output", output, "--size", "8x8"},
                                                  {"--output", output, "--runs", "0"},
                                                  {"--output", output, "--threads", "-1"},
                                                  {"--output", output, "--unknown"}};
  for (const auto& arguments : bad) EXPECT_EQ(run(arguments), EXIT_FAILURE) << arguments.back();
  EXPECT_FALSE(fs::exists(output_));
}

TEST_F(Program, RefusesWhatItCannotWriteOrRead) {
  std::ofstream(output_) << "a file";
  EXPECT_EQ(run(small(output_)), EXIT_FAILURE);
  EXPECT_EQ(run(small(output_ / "below")), EXIT_FAILURE);
  auto arguments = small(folder_.path() / "other");
  arguments.insert(arguments.end(), {"--scenes", folder_.path().string()});
  EXPECT_EQ(run(arguments), EXIT_FAILURE);
}

TEST_F(Program, SaysThatGnuplotIsMissing) {
  const std::string path = std::getenv("PATH");
  ASSERT_EQ(setenv("PATH", folder_.path().c_str(), 1), 0);
  const int code = run(small(output_));
  ASSERT_EQ(setenv("PATH", path.c_str(), 1), 0);
  EXPECT_EQ(code, EXIT_FAILURE);
}

TEST_F(Program, HelpNamesUnitsAndDefaults) {
  ChildProcess process("amalgam-report", {"--help"});
  const std::string help = process.read_all(seconds(10));
  EXPECT_EQ(process.wait(seconds(10)), 0);
  for (const char* words : {"pixels [320x240; quick: 80x60]", "1 to 1000 [20; quick: 4]",
                            "milliseconds", "--references"}) {
    EXPECT_THAT(help, HasSubstr(words));
  }
}

}  // namespace
}  // namespace amalgam::report
