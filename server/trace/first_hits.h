// The first surface that each pixel sees, without shading. Used to find edges.
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
  // Along the ray through the pixel's centre, metres; infinity for nothing.
  common::Image32f distance;
};

// One ray through the centre of each pixel of the ideal camera. Alpha cut-outs count as surface.
// Runs on the caller's TBB arena. tiles: of the picture (core/tile_grid.h); pixels of other tiles
// get kNothing.
FirstHits find_first_hits(const EmbreeScene& scene, const common::CameraModel& camera,
                          const glm::dmat4& camera_from_world, std::span<const std::size_t> tiles);

}  // namespace amalgam::trace
