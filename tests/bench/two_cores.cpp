#include "bench/two_cores.h"

#include <sched.h>

namespace amalgam::bench {

int keep_to_two_cores() {
  cpu_set_t allowed, kept;
  CPU_ZERO(&kept);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return bench_cores();
  constexpr int kCores = 2;
  for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&kept) < kCores; ++cpu) {
    if (CPU_ISSET(cpu, &allowed)) CPU_SET(cpu, &kept);
  }
  sched_setaffinity(0, sizeof kept, &kept);
  return bench_cores();
}

int bench_cores() {
  cpu_set_t allowed;
  return sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : 1;
}

}  // namespace amalgam::bench
