#include "scene/texture_lookup.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "scene/tone_map.h"

namespace amalgam::scene {
namespace {

int wrap_texel(int i, int size, Wrap wrap) {
  if (wrap == Wrap::Clamp) return std::clamp(i, 0, size - 1);
  const int period = wrap == Wrap::Repeat ? size : 2 * size;
  const int m = ((i % period) + period) % period;
  return m < size ? m : period - 1 - m;
}

glm::vec4 linear_texel(const Texture& texture, int x, int y) {
  const core::Rgba8& texel = texture.texels.at(x, y);
  return {srgb_decode(texel.x), srgb_decode(texel.y), srgb_decode(texel.z),
          static_cast<float>(texel.w) / 255.0f};
}

}  // namespace

glm::vec4 sample_color_texture(const Texture& texture, const glm::vec2& uv) {
  const int width = texture.texels.width(), height = texture.texels.height();
  const float x = uv.x * static_cast<float>(width) - 0.5f;
  const float y = uv.y * static_cast<float>(height) - 0.5f;
  if (!(std::abs(x) < 1e9f) || !(std::abs(y) < 1e9f)) return glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  const float floor_x = std::floor(x), floor_y = std::floor(y);
  const int x0 = wrap_texel(static_cast<int>(floor_x), width, texture.wrap_u);
  const int x1 = wrap_texel(static_cast<int>(floor_x) + 1, width, texture.wrap_u);
  const int y0 = wrap_texel(static_cast<int>(floor_y), height, texture.wrap_v);
  const int y1 = wrap_texel(static_cast<int>(floor_y) + 1, height, texture.wrap_v);
  const float fx = x - floor_x, fy = y - floor_y;
  return glm::mix(glm::mix(linear_texel(texture, x0, y0), linear_texel(texture, x1, y0), fx),
                  glm::mix(linear_texel(texture, x0, y1), linear_texel(texture, x1, y1), fx), fy);
}

}  // namespace amalgam::scene
