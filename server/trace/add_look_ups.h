// The camera's own colors go to the samples whose rays end on what the camera sees (eq. 4.10,
// 4.11). After all rays, so that a frame in which nothing moved needs only this of the tracer.
#pragma once

#include "common/image.h"
#include "trace/tile_paths.h"

namespace amalgam::trace {

// What the camera shows at a pixel, bilinear: scene-linear radiance, TM^-1 of the image's color.
// Pixels beyond the border are the border's.
glm::vec3 camera_radiance(const common::ImageRgb8& image, const glm::vec2& pixel, float exposure);

// In the order of paths.look_ups. image: of the camera that the look-ups were found in.
void add_look_ups(TilePaths& paths, const common::ImageRgb8& image, float exposure);

}  // namespace amalgam::trace
