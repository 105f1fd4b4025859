// What every program's main() does around its work.
#pragma once

#include <functional>

namespace amalgam::common {

// Gives work()'s exit code, or 1 after printing "name: why" in one line for what it throws. Also 1
// if standard output did not take everything: a full disk, or a pipe that nobody reads any more
// (whose signal is ignored, so that files are closed and removed in order).
int run_program(const char* name, const std::function<int()>& work);

}  // namespace amalgam::common
