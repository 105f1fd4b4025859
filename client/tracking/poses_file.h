// Marker poses as JSON: what amalgam-render's --poses takes, and what amalgam-render and
// amalgam-client print with --json.
//
//   {"poses":[{"marker":40,"rotation":[x,y,z,w],"translation":[x,y,z]}]}
//
// camera_from_marker as OpenCV gives it (x right, y down, z forward), metres, a unit quaternion.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "common/pose.h"

namespace amalgam::client {

// Throws std::runtime_error with one line that names the key.
std::vector<common::MarkerPose> load_poses(const std::filesystem::path& path);

// The list alone.
nlohmann::ordered_json poses_json(const std::vector<common::MarkerPose>& poses);

}  // namespace amalgam::client
