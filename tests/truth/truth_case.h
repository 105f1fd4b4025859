// A real scene with and without the virtual objects, path-traced, as kept in tests/truth/pictures
// (made by make_truth.sh from cases.json).
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "common/camera_model.h"
#include "common/image.h"
#include "common/pose.h"

namespace amalgam::truth {

struct TruthCase {
  std::string name;
  std::string scene_path;
  common::CameraModel camera;
  common::MarkerPose pose;  // of the world marker
};

// GoogleTest would print bytes.
inline void PrintTo(const TruthCase& truth_case, std::ostream* out) {
  *out << truth_case.name;
}

struct Environment {
  std::string name;
  std::string path;
};

inline void PrintTo(const Environment& environment, std::ostream* out) {
  *out << environment.name;
}

// One camera image and what the camera would have seen with the objects there.
struct TruthPair {
  std::string name;  // "complex-room-full-linear"
  Environment environment;
  common::ImageRgb8 camera, truth;
  // Of the truth's pixels that differ from the camera's, in 1/255.
  double noise = 0.0;
};

// How the pictures were made: which light, and by which response of the camera.
//   full    all light transport
//   direct  without caustics and without light from one diffuse surface to another
inline constexpr const char* kKinds[] = {"full-linear", "full-reinhard", "direct-linear",
                                         "direct-reinhard"};

std::vector<TruthCase> truth_cases();
std::vector<Environment> environments();

// kind: one of kKinds. Throws std::runtime_error if a picture is missing.
TruthPair load_pair(const TruthCase& truth_case, const Environment& environment,
                    const std::string& kind);

// Which share of a pixel sees virtual objects (r) and real mirrors or glass (g), 0..255.
common::ImageRgb8 load_mask(const TruthCase& truth_case);

}  // namespace amalgam::truth
