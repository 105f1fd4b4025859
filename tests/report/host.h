// Where and of what a measurement is.
#pragma once

#include <string>

namespace amalgam::report {

// The source's commit, with "-dirty" if files differ from it; "unknown" outside a repository.
std::string source_commit();

// "AMD EPYC 7763 64-Core Processor"; "unknown" where /proc does not say.
std::string processor_name();

// All threads of this process, milliseconds.
double process_cpu_milliseconds();

}  // namespace amalgam::report
