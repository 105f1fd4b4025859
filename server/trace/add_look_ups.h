// Adds the camera's own colors to the samples whose rays end on a surface that the camera sees (eq.
// 4.10, 4.11). Runs after all rays, so that a frame in which nothing moved needs no other part of
// the tracer.
#pragma once

#include "common/image.h"
#include "scene/light/real_surfaces.h"
#include "trace/tile_paths.h"

namespace amalgam::trace {

// The camera's radiance at a pixel: scene-linear, TM^-1 of the image's color, bilinear. Clamps at
// the image's border.
glm::vec3 camera_radiance(const common::ImageRgb8& image, const glm::vec2& pixel,
                          const scene::ToneMap& tone_map);

// In the order of paths.look_ups. image: of the camera that the look-ups were found in.
void add_look_ups(TilePaths& paths, const common::ImageRgb8& image, const scene::ToneMap& tone_map,
                  scene::RealSurfaces real_surfaces);

}  // namespace amalgam::trace
