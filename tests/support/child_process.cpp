#include "support/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <thread>

namespace amalgam::tests {

ChildProcess::ChildProcess(const std::string& program, std::vector<std::string> arguments,
                           Reads reads) {
  const std::string path =
      program.front() == '/' ? program : std::string(AMALGAM_BINARY_DIR) + "/bin/" + program;
  std::vector<char*> argv{const_cast<char*>(path.c_str())};
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  int pipe_ends[2];
  if (pipe2(pipe_ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("no process");
  if (pid_ == 0) {
    dup2(pipe_ends[1], STDOUT_FILENO);
    if (reads == Reads::OutputAndErrors) dup2(pipe_ends[1], STDERR_FILENO);
    execv(path.c_str(), argv.data());
    _exit(127);
  }
  close(pipe_ends[1]);
  output_ = pipe_ends[0];
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  if (output_ >= 0) close(output_);
}

bool ChildProcess::read_some(std::chrono::steady_clock::time_point until) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
      until - std::chrono::steady_clock::now());
  pollfd wanted{output_, POLLIN, 0};
  if (left.count() <= 0 || poll(&wanted, 1, static_cast<int>(left.count())) <= 0) return false;
  char bytes[4096];
  const ssize_t count = read(output_, bytes, sizeof bytes);
  if (count <= 0) return false;
  buffer_.append(bytes, static_cast<std::size_t>(count));
  return true;
}

std::string ChildProcess::read_line(std::chrono::seconds time) {
  const auto until = std::chrono::steady_clock::now() + time;
  while (buffer_.find('\n') == std::string::npos) {
    if (!read_some(until)) return {};
  }
  const std::size_t end = buffer_.find('\n');
  std::string line = buffer_.substr(0, end);
  buffer_.erase(0, end + 1);
  return line;
}

std::string ChildProcess::read_all(std::chrono::seconds time) {
  const auto until = std::chrono::steady_clock::now() + time;
  while (read_some(until)) {
  }
  return std::move(buffer_);
}

void ChildProcess::signal(int number) const {
  kill(pid_, number);
}

int ChildProcess::wait(std::chrono::seconds time) {
  const auto until = std::chrono::steady_clock::now() + time;
  int status = 0;
  while (waitpid(pid_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > until) return -1;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace amalgam::tests
