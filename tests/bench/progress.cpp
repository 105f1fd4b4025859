#include "bench/progress.h"

#include <cstdio>

#include "core/timings.h"

namespace amalgam::bench {
namespace {

const core::Stopwatch kSinceStart;

}  // namespace

void say_progress(const std::string& what) {
  std::fprintf(stderr, "[%5.1f s] %s\n", kSinceStart.milliseconds() / 1000.0, what.c_str());
}

}  // namespace amalgam::bench
