// Bilinear look-ups in the three kinds of pictures: the camera image, colour textures and the
// environment map.
#pragma once

#include "core/image.h"
#include "scene/environment.h"
#include "scene/scene.h"
#include "support/reference/vectors.h"

namespace amalgam::reference {

// Display-linear colour at pixel coordinates (a pixel's centre has integer ones): bytes are decoded
// before they are mixed. Outside, the border pixels go on.
Color sample_camera_image(const core::ImageRgb8& image, const Vec2& pixel);

// Linear RGB and alpha; uv (0, 0) is the top left corner, texel centres lie at (i + 0.5) / size.
// Texels are decoded before they are mixed; alpha is linear.
Vec4 sample_texture(const scene::Texture& texture, const Vec2& uv);

// Along a unit direction: image centre +Z, left quarter +X, right quarter -X, top row +Y. Wraps in
// longitude, clamps at the poles.
Color environment_towards(const scene::Environment& environment, const Vec3& direction);

}  // namespace amalgam::reference
