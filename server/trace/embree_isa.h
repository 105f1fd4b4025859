// The instruction set that Embree traces with.
//
// Embree takes the best that the processor has, unless the environment variable AMALGAM_ISA names
// another. Sets differ in the last bits of what they compute, so a picture that must be the same on
// several processors needs the same set on all of them (tests/README.md says by how much they
// differ).
#pragma once

#include <array>
#include <string>
#include <vector>

namespace amalgam::trace {

inline constexpr const char* kIsaVariable = "AMALGAM_ISA";
// Embree's names, the oldest set first.
inline constexpr std::array kIsas = {"sse2", "sse4.2", "avx", "avx2", "avx512"};

// For rtcNewDevice(). Throws std::runtime_error if AMALGAM_ISA is none of kIsas.
std::string embree_device_config();

// Those of kIsas that this processor and this build of Embree can run.
std::vector<std::string> usable_isas();

}  // namespace amalgam::trace
