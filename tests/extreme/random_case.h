// Scenes, poses and cameras by chance, for finding what nobody thought of.
#pragma once

#include <cstdint>
#include <string>

#include "parity/parity_case.h"

namespace amalgam::extreme {

struct RandomCase {
  parity::ParityCase parity_case;
  std::string text;  // the seed, and what the case holds, a line each
};

// The same case for the same seed, on any machine. Scenes of 1 mm to 250 m; all kinds of materials,
// real and virtual; glass in glass; lamps; the camera among them, inside glass at times.
RandomCase make_random_case(std::uint64_t seed);

}  // namespace amalgam::extreme
