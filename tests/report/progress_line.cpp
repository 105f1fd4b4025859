#include "report/progress_line.h"

#include <unistd.h>

#include <cmath>

namespace amalgam::report {
namespace {

constexpr std::chrono::seconds kBetweenLines(5);

std::string time_text(double seconds) {
  if (seconds < 90.0) return std::to_string(std::lround(seconds)) + " s";
  if (seconds < 90.0 * 60.0) return std::to_string(std::lround(seconds / 60.0)) + " min";
  return std::to_string(std::lround(seconds / 3600.0)) + " h";
}

}  // namespace

std::string progress_text(int done, int all, std::chrono::duration<double> elapsed) {
  std::string text = std::to_string(done) + " of " + std::to_string(all);
  if (done > 0) text += ", about " + time_text(elapsed.count() / done * (all - done)) + " left";
  return text;
}

ProgressLine::ProgressLine(int steps) : steps_(steps), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  clear_line();
}

void ProgressLine::say(const std::string& what) {
  const Clock::time_point now = Clock::now();
  if (!terminal_ && now - last_ < kBetweenLines) return;
  last_ = now;
  std::string text(1, '[');
  text += progress_text(done_, steps_, now - begin_) + "] " + what;
  if (terminal_) {
    // \033[K clears what an earlier, longer text left. No line break: the next text replaces this.
    std::fprintf(stderr, "\r%.100s\033[K", text.c_str());
    line_open_ = true;
  } else {
    std::fprintf(stderr, "%s\n", text.c_str());
  }
}

void ProgressLine::note(const std::string& text) {
  clear_line();
  std::fprintf(stderr, "%s\n", text.c_str());
}

void ProgressLine::clear_line() {
  if (line_open_) std::fputs("\r\033[K", stderr);
  line_open_ = false;
}

}  // namespace amalgam::report
