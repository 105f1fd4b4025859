#include "support/reference/pictures.h"

#include <cmath>

#include "support/reference/color_curves.h"

namespace amalgam::reference {
namespace {

// The four texels around a position and their mix; value(x, y) gives a texel, whatever x and y.
template <typename Value>
auto mix_bilinearly(const Vec2& position, const Value& value) {
  const double x0 = std::floor(position.x), y0 = std::floor(position.y);
  const double fx = position.x - x0, fy = position.y - y0;
  const int x = static_cast<int>(x0), y = static_cast<int>(y0);
  const auto top = (1.0 - fx) * value(x, y) + fx * value(x + 1, y);
  const auto bottom = (1.0 - fx) * value(x, y + 1) + fx * value(x + 1, y + 1);
  return (1.0 - fy) * top + fy * bottom;
}

int positive_modulo(int i, int n) {
  return ((i % n) + n) % n;
}

int wrap_index(int i, int size, scene::Wrap wrap) {
  switch (wrap) {
    case scene::Wrap::Repeat:
      return positive_modulo(i, size);
    case scene::Wrap::Mirror: {
      const int inside_pair = positive_modulo(i, 2 * size);
      return inside_pair < size ? inside_pair : 2 * size - 1 - inside_pair;
    }
    case scene::Wrap::Clamp:
      break;
  }
  return std::clamp(i, 0, size - 1);
}

Vec4 decode(const common::Rgba8& texel, TextureContent content) {
  if (content == TextureContent::Data) return Vec4(texel) / 255.0;
  return {srgb_decode_byte(texel.r), srgb_decode_byte(texel.g), srgb_decode_byte(texel.b),
          texel.a / 255.0};
}

Vec4 sample_level(const scene::Texture& texture, TextureContent content, std::size_t level,
                  const Vec2& uv) {
  const common::ImageRgba8& texels = level == 0 ? texture.texels : texture.mips[level - 1];
  return mix_bilinearly(uv * Vec2(texels.size()) - 0.5, [&](int x, int y) {
    return decode(texels.at(wrap_index(x, texels.width(), texture.wrap_u),
                            wrap_index(y, texels.height(), texture.wrap_v)),
                  content);
  });
}

}  // namespace

Color sample_camera_image(const common::ImageRgb8& image, const Vec2& pixel) {
  return mix_bilinearly(pixel, [&](int x, int y) {
    const common::Rgb8& bytes =
        image.at(std::clamp(x, 0, image.width() - 1), std::clamp(y, 0, image.height() - 1));
    return Color(srgb_decode_byte(bytes.r), srgb_decode_byte(bytes.g), srgb_decode_byte(bytes.b));
  });
}

double level_of_detail(const scene::Texture& texture, double uv_area) {
  const double texels = uv_area * texture.texels.width() * texture.texels.height();
  if (texels <= 1.0) return 0.0;
  return std::min(0.5 * std::log2(texels), static_cast<double>(texture.mips.size()));
}

Vec4 sample_texture(const scene::Texture& texture, TextureContent content, const Vec2& uv,
                    double uv_area) {
  const double level = level_of_detail(texture, uv_area);
  const auto finer = static_cast<std::size_t>(level);
  const double share = level - std::floor(level);
  const Vec4 fine = sample_level(texture, content, finer, uv);
  if (share == 0.0) return fine;
  return (1.0 - share) * fine + share * sample_level(texture, content, finer + 1, uv);
}

Color environment_towards(const scene::Environment& environment, const Vec3& direction) {
  const common::ImageRgb32f& map = environment.radiance;
  const double longitude = std::atan2(direction.x, direction.z);  // 0 at +Z, pi/2 at +X
  const double from_top = std::acos(std::clamp(direction.y, -1.0, 1.0));
  const Vec2 position((0.5 - longitude / (2.0 * kPi)) * map.width() - 0.5,
                      from_top / kPi * map.height() - 0.5);
  return mix_bilinearly(position, [&](int x, int y) {
    return Color(map.at(positive_modulo(x, map.width()), std::clamp(y, 0, map.height() - 1)));
  });
}

}  // namespace amalgam::reference
