// The rays of a frame, recorded to measure how long Embree alone needs for them.
#pragma once

#include <cstdint>
#include <vector>

#include "trace/embree_scene.h"

namespace amalgam::trace {

enum class RayQuery : std::uint8_t {
  Nearest,  // EmbreeScene::intersect
  Any,      // EmbreeScene::is_occluded
  All,      // EmbreeScene::find_all
};

struct LoggedRay {
  Ray ray;
  Visible visible = Visible::Everything;
  RayQuery query = RayQuery::Nearest;
};

// Tile by tile; within a tile in the order of the queries.
struct RayLog {
  std::vector<LoggedRay> rays;
};

}  // namespace amalgam::trace
