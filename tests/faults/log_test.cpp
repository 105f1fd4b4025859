// Rows 22 and 30: whoever logs never waits for whoever reads.
#include "common/log.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <string>

#include "common/log_limiter.h"
#include "common/standard_streams.h"
#include "faults/figure.h"

namespace amalgam::common {
namespace {

using Clock = std::chrono::steady_clock;
using test::print_figure;

// Puts another descriptor in the place of standard error for a while.
class StandardError {
 public:
  explicit StandardError(int descriptor) : kept_(::dup(STDERR_FILENO)) {
    ::dup2(descriptor, STDERR_FILENO);
  }
  ~StandardError() {
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }

 private:
  int kept_;
};

struct Pipe {
  Pipe() { EXPECT_EQ(::pipe(ends.data()), 0); }
  ~Pipe() {
    for (const int end : ends) ::close(end);
  }
  std::string read_all() {
    ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
    std::string text;
    std::array<char, 4096> bytes;
    for (ssize_t size = 0; (size = ::read(ends[0], bytes.data(), bytes.size())) > 0;) {
      text.append(bytes.data(), static_cast<std::size_t>(size));
    }
    return text;
  }
  std::array<int, 2> ends{};
};

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

class LogTo : public testing::Test {
 protected:
  void SetUp() override { set_log_level("info"); }
};

TEST_F(LogTo, APipeThatNobodyReadsStopsNobody) {
  Pipe pipe;
  const StandardError errors(pipe.ends[1]);
  const std::uint64_t before = dropped_log_lines();
  double worst = 0.0;
  Clock::time_point end_begin;
  {
    const BackgroundLog background;
    const std::string line(200, 'l');
    for (int i = 0; i < 20'000; ++i) {
      const auto begin = Clock::now();
      log_info(line);
      worst = std::max(worst, seconds_since(begin));
    }
    end_begin = Clock::now();
  }
  const double ending = seconds_since(end_begin);
  const auto dropped = static_cast<double>(dropped_log_lines() - before);
  print_figure("30", "the slowest of 20000 lines took", worst * 1000.0, "ms",
               "nothing else notices");
  print_figure("30", "lines dropped", dropped, "of 20000", "counted");
  print_figure("30", "ending the log took", ending, "s", "<= 1 s");
  EXPECT_LT(worst, 0.5);
  EXPECT_LT(ending, 5.0);
  EXPECT_GT(dropped, 15'000.0);
  // Whoever reads later gets whole lines, and learns what is missing from the next one.
  EXPECT_GT(pipe.read_all().size(), 10'000u);
  log_info("next");
  EXPECT_THAT(pipe.read_all(), testing::HasSubstr(" log lines were dropped"));
}

TEST_F(LogTo, AFullDiskOrAGoneReaderIsCountedAndSurvived) {
  std::signal(SIGPIPE, SIG_IGN);
  const int full = ::open("/dev/full", O_WRONLY);
  const int gone = [] {
    int ends[2];
    EXPECT_EQ(::pipe(ends), 0);
    ::close(ends[0]);
    return ends[1];
  }();
  for (const int descriptor : {full, gone}) {
    const StandardError errors(descriptor);
    const std::uint64_t before = dropped_log_lines();
    for (int i = 0; i < 10; ++i) log_info("lost");
    EXPECT_EQ(dropped_log_lines() - before, 10u);
  }
  ::close(full);
  ::close(gone);
}

TEST_F(LogTo, JsonIsAnObjectALineWhateverTheMessageSays) {
  Pipe pipe;
  const StandardError errors(pipe.ends[1]);
  log_info("first, in case other tests' lines are to be told of");
  pipe.read_all();
  set_log_format("json");
  log_info("quotes \" and\nlines \xff");
  set_log_format("text");
  const std::string text = pipe.read_all();
  ASSERT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  const auto line = nlohmann::json::parse(text.substr(0, text.find('\n')));
  EXPECT_EQ(line["level"], "info");
  EXPECT_THAT(line["message"].get<std::string>(), testing::StartsWith("quotes \" and\nlines "));
  EXPECT_TRUE(line.contains("time"));
  EXPECT_THROW(set_log_format("xml"), std::invalid_argument);
}

TEST(LogLimiter, EachKindHasABurstAndARate) {
  LogLimiter limiter;
  const auto start = LogLimiter::Time() + std::chrono::hours(1);
  int lines = 0;
  for (int i = 0; i < 575; ++i) lines += limiter.admit(LogKind::Refusal, start) ? 1 : 0;
  print_figure("30", "lines for 575 refusals at once", lines, "", "limited by kind");
  EXPECT_EQ(lines, 20);
  EXPECT_EQ(limiter.admit(LogKind::Session, start), 0u);  // another kind is not touched
  // A second later there is room for ten, and the first tells what is missing.
  const auto later = start + std::chrono::seconds(1);
  EXPECT_EQ(limiter.admit(LogKind::Refusal, later), 555u);
  EXPECT_EQ(limiter.admit(LogKind::Refusal, later), 0u);
}

TEST(StandardStreams, ClosedOnesAreOpenedAgain) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(STDERR_FILENO);
    ::close(STDIN_FILENO);
    open_closed_standard_streams();
    const int next = ::open("/dev/null", O_RDONLY);
    ::_exit(::fcntl(STDERR_FILENO, F_GETFD) >= 0 && next > STDERR_FILENO ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace amalgam::common
