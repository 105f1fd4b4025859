#include "codec/exr_cube.h"

#include <ImfEnvmap.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace amalgam::codec {
namespace {

glm::vec3 sample(const common::ImageRgb32f& cube, const Imath::V3f& direction) {
  const int side = cube.width();
  const Imath::Box2i window(Imath::V2i(0), Imath::V2i(side - 1, 6 * side - 1));
  Imf::CubeMapFace face{};
  Imath::V2f in_face;
  Imf::CubeMap::faceAndPixelPosition(direction, window, face, in_face);
  const auto split = [&](float position) {
    const int low = std::clamp(static_cast<int>(position), 0, std::max(side - 2, 0));
    return std::pair(low, std::clamp(position - static_cast<float>(low), 0.0f, 1.0f));
  };
  const auto [x, fx] = split(in_face.x);
  const auto [y, fy] = split(in_face.y);
  const auto texel = [&, x = x, y = y](int dx, int dy) {
    const Imath::V2f in_image =
        Imf::CubeMap::pixelPosition(face, window,
                                    Imath::V2f(static_cast<float>(std::min(x + dx, side - 1)),
                                               static_cast<float>(std::min(y + dy, side - 1))));
    return cube.at(static_cast<int>(std::lround(in_image.x)),
                   static_cast<int>(std::lround(in_image.y)));
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), fx), glm::mix(texel(0, 1), texel(1, 1), fx),
                  fy);
}

}  // namespace

std::optional<common::ImageRgb32f> equirectangular_from_cube(const common::ImageRgb32f& cube) {
  const int side = cube.width();
  if (side < 1 || cube.height() != 6 * side) return std::nullopt;
  constexpr double kPi = std::numbers::pi;
  common::ImageRgb32f map(4 * side, 2 * side);
  for (int row = 0; row < map.height(); ++row) {
    const double colatitude = kPi * (row + 0.5) / map.height();
    for (int column = 0; column < map.width(); ++column) {
      // Image centre +Z, left quarter +X.
      const double longitude = 2.0 * kPi * (0.5 - (column + 0.5) / map.width());
      const double across = std::sin(colatitude);
      map.at(column, row) =
          sample(cube, Imath::V3f(static_cast<float>(across * std::sin(longitude)),
                                  static_cast<float>(std::cos(colatitude)),
                                  static_cast<float>(across * std::cos(longitude))));
    }
  }
  return map;
}

}  // namespace amalgam::codec
