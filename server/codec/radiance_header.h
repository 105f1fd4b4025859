// The text at the begin of a Radiance picture: its lines "NAME=value" and its size.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

#include "codec/color_space.h"

namespace amalgam::codec {

struct RadianceHeader {
  bool is_xyz = false;       // XYZE instead of RGBE
  glm::dvec3 exposure{1.0};  // what the pixels have been multiplied by
  std::optional<Chromaticities> primaries{};
  glm::ivec2 size{0};
  bool by_columns = false;  // scan lines are columns
  bool right_to_left = false, bottom_up = false;
  std::size_t pixels_at = 0;  // bytes
};

// Throws PictureError. The size is not checked against limits.
RadianceHeader read_radiance_header(std::string_view file);

}  // namespace amalgam::codec
