// Bilinear look-ups in the three kinds of pictures: the camera image, color textures and the
// environment map.
#pragma once

#include "common/image.h"
#include "scene/light/environment.h"
#include "scene/scene.h"
#include "support/reference/vectors.h"

namespace amalgam::reference {

// Display-linear color at pixel coordinates (a pixel's centre has integer ones): bytes are decoded
// before they are mixed. Outside, the border pixels go on.
Color sample_camera_image(const common::ImageRgb8& image, const Vec2& pixel);

enum class TextureContent { Color, Data };  // sRGB-encoded; linear. Alpha always is linear

// How far down the chain of halved sizes to read so that a texel covers what a sample covers:
//   log2(uv_area width height) / 2,
// at least 0 (the full size) and at most the last one. uv_area: what the sample covers in uv.
double level_of_detail(const scene::Texture& texture, double uv_area);

// RGB and alpha in [0, 1]; uv (0, 0) is the top left corner, texel centres lie at (i + 0.5) / size.
// Texels are decoded before they are mixed, levels are mixed linearly.
Vec4 sample_texture(const scene::Texture& texture, TextureContent content, const Vec2& uv,
                    double uv_area = 0.0);

// Along a unit direction: image centre +Z, left quarter +X, right quarter -X, top row +Y. Wraps in
// longitude, clamps at the poles.
Color environment_towards(const scene::Environment& environment, const Vec3& direction);

}  // namespace amalgam::reference
