#include "client/synthetic/desk_mirror.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "common/pose.h"

namespace amalgam::client {
namespace {

// Of the node "real mirror": translation, rotation and scale in glTF's marker frame, and its
// material's color.
const glm::dvec3 kTranslation{-0.12, 0.0017, -0.15};
const glm::dquat kRotation{0.9803262614787073, -0.12036892955724911, 0.15526842625975007,
                           0.019064565540388434};  // w first
const glm::dvec3 kScale{0.16, 0.13, 0.006};
constexpr double kColor = 0.9;

double decode(std::uint32_t byte) {
  const double encoded = byte / 255.0;
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::uint8_t encode(double linear) {
  const double encoded =
      linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

}  // namespace

DeskMirror::DeskMirror() {
  const glm::dmat3 marker_from_gltf(common::opencv_marker_from_gltf());
  glm::dmat3 marker_from_box = marker_from_gltf * glm::mat3_cast(kRotation);
  for (int i = 0; i < 3; ++i) marker_from_box[i] *= kScale[i];
  box_from_marker_ = glm::inverse(marker_from_box);
  place_ = marker_from_gltf * kTranslation;
}

std::optional<DeskMirror::Meeting> DeskMirror::meet(const glm::dvec3& origin,
                                                    const glm::dvec3& direction) const {
  const glm::dvec3 o = box_from_marker_ * (origin - place_) - glm::dvec3(0.0, 0.5, 0.0);
  const glm::dvec3 d = box_from_marker_ * direction;
  double enters = 0.0, leaves = std::numeric_limits<double>::infinity();
  int axis = -1;
  for (int i = 0; i < 3; ++i) {
    if (d[i] == 0.0) {
      if (std::abs(o[i]) > 0.5) return std::nullopt;
      continue;
    }
    const double side = std::copysign(0.5, d[i]);
    const double in = (-side - o[i]) / d[i];
    leaves = std::min(leaves, (side - o[i]) / d[i]);
    if (in > enters) {
      enters = in;
      axis = i;
    }
  }
  if (axis < 0 || enters >= leaves) return std::nullopt;
  // Normals transform by the inverse transpose: rows of box_from_marker.
  const glm::dvec3 row = glm::transpose(box_from_marker_)[axis];
  return Meeting{enters, glm::normalize(d[axis] > 0 ? -row : row)};
}

PackedColor DeskMirror::dim(PackedColor color, double cosine) {
  const double reflectance = kColor + (1.0 - kColor) * std::pow(1.0 - cosine, 5);
  const auto channel = [&](int shift) {
    return encode(reflectance * decode(color >> shift & 255));
  };
  return pack(common::Rgb8(channel(0), channel(8), channel(16)));
}

}  // namespace amalgam::client
