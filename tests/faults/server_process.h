// amalgam-server as a program, with a standard error of the test's choice.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

#include "common/host_port.h"

namespace amalgam::test {

class ServerProcess {
 public:
  // stderr_descriptor: -1 closes it. Waits until it serves; throws std::runtime_error otherwise.
  ServerProcess(std::vector<std::string> arguments, int stderr_descriptor);
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  void signal(int number) const;
  bool is_running();
  // Seconds until it has ended, or -1; its exit code is then in exit_code().
  double wait(std::chrono::seconds time);
  int exit_code() const { return exit_code_; }
  const common::HostPort& address() const { return address_; }
  const common::HostPort& admin_address() const { return admin_; }
  const common::HostPort& agent_address() const { return agent_; }  // with --agent-check
  pid_t id() const { return pid_; }

 private:
  pid_t pid_ = -1;
  int exit_code_ = -1;
  common::HostPort address_, admin_, agent_;
};

}  // namespace amalgam::test
