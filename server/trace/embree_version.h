// Embree's version, for --version and the admin port.
#pragma once

#include <string>

namespace amalgam::trace {

// "Embree 3.13.5, packets of 4 and 8". The packet sizes that this processor traces natively tell
// which instruction set Embree chose (4: SSE, 8: AVX, 16: AVX-512).
std::string embree_version();

}  // namespace amalgam::trace
