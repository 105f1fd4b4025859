// What Embree says of itself, for --version and the admin port.
#pragma once

#include <string>

namespace amalgam::trace {

// "Embree 3.13.5, packets of 4 and 8": how many rays at a time this processor traces natively, by
// which one knows the instruction set that Embree chose (4: SSE, 8: AVX, 16: AVX-512).
std::string embree_version();

}  // namespace amalgam::trace
