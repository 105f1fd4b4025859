// How many cores this process may use. The scheduler's affinity (taskset, cpusets) and the CPU
// quotas of cgroups (containers, systemd) may leave fewer than the machine has. More threads than
// that only take turns.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace amalgam::core {

// At least 1. A quota of part of a core counts as a whole one.
int usable_cpus();

// The CPU quota in cores (1.5: one and a half): the least of the process's cgroup and its
// ancestors; nothing if there is none. cgroup_file: the text of /proc/self/cgroup. mounts: where
// cgroups are mounted, /sys/fs/cgroup. Version 2 (cpu.max) and version 1 (cpu.cfs_quota_us,
// cpu.cfs_period_us).
std::optional<double> cgroup_cpu_quota(std::string_view cgroup_file,
                                       const std::filesystem::path& mounts);

// The quota as a number of cores, clamped to [1, cpus].
int cpus_within(int cpus, std::optional<double> quota);

}  // namespace amalgam::core
