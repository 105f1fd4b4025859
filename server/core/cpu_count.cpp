#include "core/cpu_count.h"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>

namespace amalgam::core {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// "150000 100000" is one and a half cores; "max" and version 1's -1 are none.
std::optional<double> parse_quota(const std::string& quota_and_period) {
  std::istringstream text(quota_and_period);
  double quota = 0.0, period = 0.0;
  if (!(text >> quota >> period) || !(quota > 0.0) || !(period > 0.0)) return std::nullopt;
  return quota / period;
}

std::optional<double> quota_of(const fs::path& folder) {
  if (const auto quota = parse_quota(read_file(folder / "cpu.max"))) return quota;
  return parse_quota(read_file(folder / "cpu.cfs_quota_us") + " " +
                     read_file(folder / "cpu.cfs_period_us"));
}

std::optional<double> smaller(std::optional<double> a, std::optional<double> b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

// Of the group and its ancestors. In a container the path may be the host's, while the container's
// own group is mounted as the root. A group that is not found has no quota.
std::optional<double> quota_along(const fs::path& root, const fs::path& group) {
  std::optional<double> quota = quota_of(root);
  fs::path folder = root;
  for (const fs::path& part : group.relative_path()) {
    if (part == "..") break;
    folder /= part;
    quota = smaller(quota, quota_of(folder));
  }
  return quota;
}

bool names_cpu(std::string_view controllers) {
  std::istringstream list{std::string(controllers)};
  for (std::string name; std::getline(list, name, ',');) {
    if (name == "cpu") return true;
  }
  return false;
}

int cpus_by_affinity() {
  cpu_set_t set;
  CPU_ZERO(&set);
  // Fails on machines with more than 1024 cores; all of them may then be used.
  if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
  return static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

std::optional<double> cgroup_cpu_quota(std::string_view cgroup_file, const fs::path& mounts) {
  std::optional<double> quota;
  std::istringstream lines{std::string(cgroup_file)};
  // "0::/group" for version 2, "4:cpu,cpuacct:/group" for version 1.
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path group = line.substr(second + 1);
    if (controllers.empty()) {
      quota = smaller(quota, quota_along(mounts, group));
    } else if (names_cpu(controllers)) {
      quota = smaller(quota, quota_along(mounts / controllers, group));
      if (controllers != "cpu") quota = smaller(quota, quota_along(mounts / "cpu", group));
    }
  }
  return quota;
}

int cpus_within(int cpus, std::optional<double> quota) {
  const int whole = quota ? static_cast<int>(std::ceil(std::min(*quota, 1e6))) : cpus;
  return std::clamp(whole, 1, std::max(cpus, 1));
}

int usable_cpus() {
  return cpus_within(cpus_by_affinity(),
                     cgroup_cpu_quota(read_file("/proc/self/cgroup"), "/sys/fs/cgroup"));
}

}  // namespace amalgam::core
