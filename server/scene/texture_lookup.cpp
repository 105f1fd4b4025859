#include "scene/texture_lookup.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/light/tone_map.h"

namespace amalgam::scene {
namespace {

int wrap_texel(int i, int size, Wrap wrap) {
  if (wrap == Wrap::Clamp) return std::clamp(i, 0, size - 1);
  const int period = wrap == Wrap::Repeat ? size : 2 * size;
  const int m = ((i % period) + period) % period;
  return m < size ? m : period - 1 - m;
}

float decode_linear(std::uint8_t byte) {
  return static_cast<float>(byte) / 255.0f;
}

using Decode = float (*)(std::uint8_t);

template <Decode decode>
glm::vec4 decoded(const common::Rgba8& texel) {
  return {decode(texel.x), decode(texel.y), decode(texel.z), decode_linear(texel.w)};
}

template <Decode decode>
glm::vec4 sample_level(const Texture& texture, int level, const glm::vec2& uv) {
  const common::ImageRgba8& texels =
      level == 0 ? texture.texels : texture.mips[static_cast<std::size_t>(level - 1)];
  const int width = texels.width(), height = texels.height();
  const float x = uv.x * static_cast<float>(width) - 0.5f;
  const float y = uv.y * static_cast<float>(height) - 0.5f;
  if (!(std::abs(x) < kMaxTexelPlace) || !(std::abs(y) < kMaxTexelPlace))
    return glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  const float floor_x = std::floor(x), floor_y = std::floor(y);
  const int x0 = wrap_texel(static_cast<int>(floor_x), width, texture.wrap_u);
  const int x1 = wrap_texel(static_cast<int>(floor_x) + 1, width, texture.wrap_u);
  const int y0 = wrap_texel(static_cast<int>(floor_y), height, texture.wrap_v);
  const int y1 = wrap_texel(static_cast<int>(floor_y) + 1, height, texture.wrap_v);
  const float fx = x - floor_x, fy = y - floor_y;
  const auto texel = [&](int i, int j) { return decoded<decode>(texels.at(i, j)); };
  return glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), fx),
                  glm::mix(texel(x0, y1), texel(x1, y1), fx), fy);
}

template <Decode decode>
glm::vec4 sample(const Texture& texture, const glm::vec2& uv, float footprint) {
  const auto coarsest = static_cast<float>(texture.mips.size());
  const auto area =
      static_cast<float>(texture.texels.width()) * static_cast<float>(texture.texels.height());
  const float texels = footprint * area;
  if (!(texels > 1.0f) || coarsest == 0.0f) return sample_level<decode>(texture, 0, uv);
  const float lod = std::min(0.5f * std::log2(texels), coarsest);
  const float level = std::floor(lod);
  const glm::vec4 fine = sample_level<decode>(texture, static_cast<int>(level), uv);
  if (level == coarsest) return fine;
  return glm::mix(fine, sample_level<decode>(texture, static_cast<int>(level) + 1, uv),
                  lod - level);
}

}  // namespace

glm::vec4 sample_color_texture(const Texture& texture, const glm::vec2& uv, float footprint) {
  return sample<srgb_decode>(texture, uv, footprint);
}

glm::vec4 sample_data_texture(const Texture& texture, const glm::vec2& uv, float footprint) {
  return sample<decode_linear>(texture, uv, footprint);
}

float uv_footprint(float uv_area_per_area, float cone_width, float cosine) {
  const float side = cone_width / std::max(std::abs(cosine), kMinFootprintCosine);
  return uv_area_per_area * side * side;
}

float uv_area_ratio(const Mesh& mesh, const std::vector<glm::vec2>& uvs,
                    const glm::uvec3& corners) {
  if (uvs.empty()) return 0.0f;
  const glm::dvec3 a(mesh.positions[corners.x]);
  const double area = glm::length(glm::cross(glm::dvec3(mesh.positions[corners.y]) - a,
                                             glm::dvec3(mesh.positions[corners.z]) - a));
  const glm::dvec2 u(uvs[corners.x]);
  const glm::dvec2 v = glm::dvec2(uvs[corners.y]) - u, w = glm::dvec2(uvs[corners.z]) - u;
  return static_cast<float>(std::abs(v.x * w.y - v.y * w.x) / area);
}

}  // namespace amalgam::scene
