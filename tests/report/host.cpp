#include "report/host.h"

#include <ctime>
#include <fstream>

#include "bench/shell.h"

namespace amalgam::report {

std::string source_commit() {
  std::string text =
      bench::output_of("git -C " + bench::quoted(AMALGAM_SOURCE_DIR) +
                       " describe --always --dirty --abbrev=12 --match= 2>/dev/null");
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.empty() ? "unknown" : text;
}

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

double process_cpu_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace amalgam::report
