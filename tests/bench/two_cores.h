// The goals are for two cores. On a larger machine the process keeps to two of them, so that
// Mesa's threads, TBB's and a child process's do as well.
#pragma once

namespace amalgam::bench {

// To be called before any thread is started. Returns the number of cores kept: 2, or fewer where
// there are no more.
int keep_to_two_cores();

// The number of cores that this process may use.
int bench_cores();

}  // namespace amalgam::bench
