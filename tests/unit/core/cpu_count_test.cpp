#include "core/cpu_count.h"

#include <gtest/gtest.h>

#include <fstream>

namespace amalgam::core {
namespace {

namespace fs = std::filesystem;

// A made-up /sys/fs/cgroup.
class CpuCount : public testing::Test {
 protected:
  CpuCount() { fs::remove_all(mounts_); }
  ~CpuCount() override { fs::remove_all(mounts_); }

  void write(const fs::path& file, const std::string& text) const {
    fs::create_directories((mounts_ / file).parent_path());
    std::ofstream(mounts_ / file) << text << "\n";
  }

  // A folder a test, because tests run side by side.
  const fs::path mounts_ = fs::path(testing::TempDir()) / "amalgam-cpu-count-test" /
                           testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(CpuCount, Version2) {
  write("system.slice/amalgam.service/cpu.max", "150000 100000");
  EXPECT_EQ(cgroup_cpu_quota("0::/system.slice/amalgam.service\n", mounts_), 1.5);
}

TEST_F(CpuCount, NoQuotaIsNone) {
  write("cpu.max", "max 100000");
  write("cpu/cpu.cfs_quota_us", "-1");
  write("cpu/cpu.cfs_period_us", "100000");
  EXPECT_FALSE(cgroup_cpu_quota("4:cpu,cpuacct:/\n0::/\n", mounts_));
  EXPECT_FALSE(cgroup_cpu_quota("", mounts_));
  EXPECT_FALSE(cgroup_cpu_quota("nonsense\n::\n0:\n", mounts_));
}

// A group around ours may have less than ours.
TEST_F(CpuCount, TheLeastOnTheWayCounts) {
  write("outer/cpu.max", "200000 100000");
  write("outer/inner/cpu.max", "400000 100000");
  EXPECT_EQ(cgroup_cpu_quota("0::/outer/inner\n", mounts_), 2.0);
}

// Docker with its own cgroup namespace or version 1: the path is the host's, the mount ours.
TEST_F(CpuCount, InAContainerTheMountIsTheGroup) {
  write("cpu.max", "50000 100000");
  EXPECT_EQ(cgroup_cpu_quota("0::/docker/0123456789ab\n", mounts_), 0.5);
  EXPECT_EQ(cgroup_cpu_quota("0::/../../other\n", mounts_), 0.5);
}

TEST_F(CpuCount, Version1) {
  write("cpu,cpuacct/jobs/cpu.cfs_quota_us", "300000");
  write("cpu,cpuacct/jobs/cpu.cfs_period_us", "100000");
  const std::string lines = "5:memory:/elsewhere\n4:cpu,cpuacct:/jobs\n3:cpuset:/\n";
  EXPECT_EQ(cgroup_cpu_quota(lines, mounts_), 3.0);
}

// Where the controllers are mounted each under its own name, or "cpuset" is all there is.
TEST_F(CpuCount, Version1UnderOneName) {
  write("cpu/cpu.cfs_quota_us", "120000");
  write("cpu/cpu.cfs_period_us", "100000");
  EXPECT_EQ(cgroup_cpu_quota("4:cpu,cpuacct:/\n", mounts_), 1.2);
  EXPECT_FALSE(cgroup_cpu_quota("4:cpuset,cpuacct:/\n", mounts_));
}

TEST_F(CpuCount, PartOfACoreIsOne) {
  EXPECT_EQ(cpus_within(8, 1.5), 2);
  EXPECT_EQ(cpus_within(8, 2.0), 2);
  EXPECT_EQ(cpus_within(8, 0.01), 1);
  EXPECT_EQ(cpus_within(2, 16.0), 2);
  EXPECT_EQ(cpus_within(8, std::nullopt), 8);
  EXPECT_EQ(cpus_within(0, std::nullopt), 1);
  EXPECT_GE(usable_cpus(), 1);
}

}  // namespace
}  // namespace amalgam::core
