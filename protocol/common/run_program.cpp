#include "common/run_program.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <string>

namespace amalgam::common {
namespace {

int complain(const char* name, const std::string& why) {
  const std::string line = why.substr(0, why.find('\n'));  // libraries' texts have several
  std::fprintf(stderr, "%s: %s\n", name, line.c_str());
  return EXIT_FAILURE;
}

}  // namespace

int run_program(const char* name, const std::function<int()>& work) {
  std::signal(SIGPIPE, SIG_IGN);
  int exit_code = EXIT_FAILURE;
  try {
    exit_code = work();
  } catch (const std::exception& error) {
    exit_code = complain(name, error.what());
  }
  errno = 0;
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good()) return exit_code;
  const std::string reason = errno != 0 ? std::strerror(errno) : "not everything was written";
  return complain(name, "standard output: " + reason);
}

}  // namespace amalgam::common
