// How many cores this process may use, which may be fewer than the machine has: the scheduler's
// affinity (taskset, cpusets) and CPU quotas of cgroups (containers, systemd) both lessen them.
// Threads beyond that only take turns.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace amalgam::core {

// At least 1. A quota of part of a core counts as a whole one.
int usable_cpus();

// The quota in cores (1.5: one and a half), the least of those of the process's cgroup and all
// around it; nothing if there is none. cgroup_file: /proc/self/cgroup; mounts: where cgroups are
// mounted, /sys/fs/cgroup. Version 2 (cpu.max) and version 1 (cpu.cfs_quota_us, cpu.cfs_period_us).
std::optional<double> cgroup_cpu_quota(std::string_view cgroup_file,
                                       const std::filesystem::path& mounts);

// A number of cores that holds the quota and is within [1, cpus].
int cpus_within(int cpus, std::optional<double> quota);

}  // namespace amalgam::core
