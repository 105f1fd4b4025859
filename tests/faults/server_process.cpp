#include "faults/server_process.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>
#include <thread>

namespace amalgam::test {

ServerProcess::ServerProcess(std::vector<std::string> arguments, int stderr_descriptor) {
  const std::string path = std::string(AMALGAM_BINARY_DIR) + "/bin/amalgam-server";
  arguments.insert(arguments.begin(), {path, "--listen", "127.0.0.1:0", "--admin", "127.0.0.1:0",
                                       "--renderer", "raytrace"});
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  pid_ = ::fork();
  if (pid_ == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    stderr_descriptor >= 0 ? ::dup2(stderr_descriptor, STDERR_FILENO) : ::close(STDERR_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    ::execv(path.c_str(), argv.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  std::FILE* const output = ::fdopen(ends[0], "r");
  char line[256] = "", listen[64] = "", admin[64] = "", agent[64] = "";
  const bool said = std::fgets(line, sizeof line, output) != nullptr;
  std::fclose(output);
  const int read =
      std::sscanf(line, "listening on %63s admin %63s agent %63s", listen, admin, agent);
  if (!said || read < 2) throw std::runtime_error("the server does not serve");
  address_ = common::parse_host_port(listen);
  admin_ = common::parse_host_port(admin);
  if (read == 3) agent_ = common::parse_host_port(agent);
}

ServerProcess::~ServerProcess() {
  if (pid_ <= 0 || exit_code_ >= 0) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

void ServerProcess::signal(int number) const {
  ::kill(pid_, number);
}

bool ServerProcess::is_running() {
  return wait(std::chrono::seconds(0)) < 0;
}

double ServerProcess::wait(std::chrono::seconds time) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  for (int status = 0;;) {
    if (::waitpid(pid_, &status, WNOHANG) == pid_) {
      exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      return std::chrono::duration<double>(Clock::now() - begin).count();
    }
    if (Clock::now() - begin >= time) return -1.0;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace amalgam::test
