// A program started by a test: its output is read, it is ended by its own id, and never outlives
// the test.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace amalgam::tests {

class ChildProcess {
 public:
  // Standard error goes to the test's own, or is read together with standard output.
  enum class Reads { Output, OutputAndErrors };

  // Runs a program of the build's bin folder, or one named by its path. Throws std::runtime_error.
  ChildProcess(const std::string& program, std::vector<std::string> arguments,
               Reads reads = Reads::Output);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // The next line of standard output without its end. Empty at the end of the output or after the
  // time.
  std::string read_line(std::chrono::seconds time);
  std::string read_all(std::chrono::seconds time);
  void signal(int number) const;
  pid_t id() const { return pid_; }
  // The exit code, or -1 if the program did not end in time (then it is killed) or was killed by a
  // signal.
  int wait(std::chrono::seconds time);

 private:
  bool read_some(std::chrono::steady_clock::time_point until);

  pid_t pid_ = -1;
  int output_ = -1;
  std::string buffer_;
};

}  // namespace amalgam::tests
