// A texture of two colors side by side, each two texels wide, so that a quarter of the way in from
// either edge one color is read alone.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace amalgam::trace {

inline std::uint32_t add_halves(scene::Scene& scene, const common::Rgba8& left,
                                const common::Rgba8& right) {
  scene::Texture texture;
  texture.texels = common::ImageRgba8(4, 1, left);
  texture.texels.at(2, 0) = texture.texels.at(3, 0) = right;
  texture.wrap_u = scene::Wrap::Clamp;
  scene.textures.push_back(texture);
  return static_cast<std::uint32_t>(scene.textures.size() - 1);
}

}  // namespace amalgam::trace
