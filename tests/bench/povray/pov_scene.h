// A case in POV-Ray's scene description language: the same meshes with the same normals, glass with
// the same index and absorption, the same lights as parallel lights, the same camera.
//
// What differs: POV-Ray knows no camera image, so real surfaces are as modelled; base colors only,
// no textures; its Phong highlight is not multiplied by the cosine; a branch that ends is black.
#pragma once

#include <filesystem>

#include "bench/bench_case.h"
#include "trace/tracer.h"

namespace amalgam::bench {

// Writes scene.pov and environment.exr to the folder; returns the former's path. Throws
// std::runtime_error.
std::filesystem::path write_pov_scene(const BenchCase& bench_case,
                                      const trace::TraceSettings& settings,
                                      const std::filesystem::path& folder);

}  // namespace amalgam::bench
