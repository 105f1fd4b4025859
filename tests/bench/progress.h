// What the bench is doing, on standard error, for who waits.
#pragma once

#include <string>

namespace amalgam::bench {

// One line with the seconds since the program began.
void say_progress(const std::string& what);

}  // namespace amalgam::bench
