#include "client/synthetic/synthetic_camera.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>

#include "client/synthetic/synthetic_path.h"

namespace amalgam::client {
namespace {

constexpr int kSamplesPerSide = 2;  // a pixel is the mean of 2x2

// Samples lie in the middle of their part of the pixel, whose centre has whole coordinates.
double sample_position(int sample) {
  return (sample + 0.5) / kSamplesPerSide - 0.5;
}

// The wall behind the desk, colored by the ray's slope, so that mirrors and horizons show a
// direction.
PackedColor wall(const glm::dvec3& direction) {
  const double height = direction.z / glm::length(direction);
  const auto lit = static_cast<float>(glm::clamp(0.55 + 0.6 * height, 0.25, 1.0));
  return pack(common::Rgb8(glm::vec3(196, 208, 220) * lit));
}

}  // namespace

SyntheticCamera::SyntheticCamera(const common::CameraModel& camera)
    : SyntheticCamera(camera, std::make_shared<const SyntheticDesk>(PrintedMarker{})) {}

SyntheticCamera::SyntheticCamera(const common::CameraModel& camera,
                                 std::shared_ptr<const SyntheticDesk> desk)
    : camera_(camera), desk_(std::move(desk)) {
  if (const std::string defect = common::describe_defect(camera); !defect.empty()) {
    throw std::runtime_error("the synthetic camera cannot be made: " + defect);
  }
  if (!camera.has_distortion()) {
    for (int x = 0; x < camera.width * kSamplesPerSide; ++x) {
      column_x_.push_back((sample_position(x) - camera.cx) / camera.fx);
    }
    for (int y = 0; y < camera.height * kSamplesPerSide; ++y) {
      row_y_.push_back((sample_position(y) - camera.cy) / camera.fy);
    }
    return;
  }
  // Inverting the lens costs more than all else of a sample, and is the same in every frame.
  const int width = camera.width * kSamplesPerSide, height = camera.height * kSamplesPerSide;
  distorted_rays_.reserve(common::checked_pixel_count(width, height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto direction =
          common::pixel_direction(camera, {sample_position(x), sample_position(y)});
      if (!direction) throw std::runtime_error("the lens cannot be inverted at a pixel");
      distorted_rays_.emplace_back(direction->x, direction->y);
    }
  }
}

SyntheticFrame SyntheticCamera::render(std::uint64_t frame) const {
  const common::MarkerPose pose = synthetic_pose(frame, desk_->marker().id);
  return {render(pose), pose};
}

glm::dvec2 SyntheticCamera::ray(int sample_x, int sample_y) const {
  if (!distorted_rays_.empty()) {
    const auto row = static_cast<std::size_t>(sample_y) *
                     static_cast<std::size_t>(camera_.width * kSamplesPerSide);
    return distorted_rays_[row + static_cast<std::size_t>(sample_x)];
  }
  return {column_x_[static_cast<std::size_t>(sample_x)],
          row_y_[static_cast<std::size_t>(sample_y)]};
}

PackedColor SyntheticCamera::look(const Sight& sight, double sample_angle) const {
  const auto met = desk_->mirror() ? desk_->mirror()->meet(sight.from, sight.direction)
                                   : std::optional<DeskMirror::Meeting>();
  if (!met) return look_at_desk(sight, sample_angle);
  const double towards = -glm::dot(sight.direction, met->normal);
  const Sight reflected{sight.from + met->t * sight.direction,
                        sight.direction + 2.0 * towards * met->normal, sight.distance + met->t};
  return DeskMirror::dim(look_at_desk(reflected, sample_angle),
                         towards / glm::length(sight.direction));
}

PackedColor SyntheticCamera::look_at_desk(const Sight& sight, double sample_angle) const {
  const double distance = -sight.from.z / sight.direction.z;
  if (!(distance > 0)) return wall(sight.direction);
  const glm::dvec2 point = glm::dvec2(sight.from) + distance * glm::dvec2(sight.direction);
  if (!desk_->covers(point)) return wall(sight.direction);
  return desk_->color(point, (sight.distance + distance) * sample_angle);
}

common::ImageRgb8 SyntheticCamera::render(const common::MarkerPose& pose) const {
  const glm::dmat4 marker_from_camera = common::rigid_inverse(common::to_matrix(pose));
  const glm::dmat3 rotation(marker_from_camera);
  const glm::dvec3 eye(marker_from_camera[3]);
  const double sample_angle = 1.0 / (kSamplesPerSide * camera_.fx);  // radians, about

  const auto see = [&](int sample_x, int sample_y) {
    const glm::dvec2 at = ray(sample_x, sample_y);
    return look({eye, rotation * glm::dvec3(at, 1.0)}, sample_angle);
  };

  common::ImageRgb8 image(camera_.width, camera_.height);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      // The mean of encoded values, not of light: a mean of light would shift every black-white
      // edge into the black, and the marker would be measured too small.
      PackedMean<kSamplesPerSide * kSamplesPerSide> mean;
      for (int j = 0; j < kSamplesPerSide; ++j) {
        for (int i = 0; i < kSamplesPerSide; ++i) {
          mean.add(see(x * kSamplesPerSide + i, y * kSamplesPerSide + j));
        }
      }
      image.at(x, y) = mean.mean();
    }
  }
  return image;
}

}  // namespace amalgam::client
