// The program's version and the processors that it was compiled for.
#pragma once

#include <string>

namespace amalgam::common {

// "0.1.0", of the project.
const char* version();

// "x86-64", "x86-64-v2", "-v3" or "-v4", by the instructions that the compiler may use; "other" on
// other processors.
const char* instruction_set();

// The linker's hash of this program's code and data (its build id), in hexadecimal digits: equal
// for equal programs. Empty if the linker gave none.
std::string build_id();

// For --version: "amalgam-server 0.1.0, compiled for x86-64".
std::string version_line(const std::string& program);

}  // namespace amalgam::common
