// What each pixel sees first, without shading it: where to look for edges.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>

#include "common/camera_model.h"
#include "common/image.h"
#include "trace/embree_scene.h"

namespace amalgam::trace {

struct FirstHits {
  static constexpr std::uint32_t kNothing = 0xffffffffu;
  common::Image<std::uint32_t> instance;  // index into Scene::instances, or kNothing
  common::Image32f
      distance;  // along the ray through the pixel's centre, metres; infinity for nothing
};

// One ray a pixel of the ideal camera, through its centre. Masked-out texels count as surface. Runs
// on the caller's TBB arena. tiles: of the picture (core/tile_grid.h); pixels of others are left as
// if they saw nothing.
FirstHits find_first_hits(const EmbreeScene& scene, const common::CameraModel& camera,
                          const glm::dmat4& camera_from_world, std::span<const std::size_t> tiles);

}  // namespace amalgam::trace
