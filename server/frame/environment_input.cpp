#include "frame/environment_input.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "codec/jpeg.h"
#include "scene/light/tone_map.h"

namespace amalgam::frame {
namespace {

// Finer than reflections show.
constexpr int kUnrolledWidth = 512, kUnrolledHeight = 256;

glm::vec3 bilinear(const common::ImageRgb8& picture, const glm::dvec2& at) {
  const auto texel = [&](double x, double y) {
    const int i = std::clamp(static_cast<int>(x), 0, picture.width() - 1);
    const int j = std::clamp(static_cast<int>(y), 0, picture.height() - 1);
    return scene::srgb_decode(picture.at(i, j));
  };
  const double x = std::floor(at.x), y = std::floor(at.y);
  const auto fx = static_cast<float>(at.x - x), fy = static_cast<float>(at.y - y);
  return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), fx),
                  glm::mix(texel(x, y + 1), texel(x + 1, y + 1), fx), fy);
}

std::optional<glm::vec3> seen_color(const common::ImageRgb8& picture,
                                    const common::FisheyeModel& fisheye,
                                    const glm::dvec3& direction) {
  const auto pixel = common::project(fisheye, direction);
  if (!pixel || pixel->x < -0.5 || pixel->y < -0.5 || pixel->x > picture.width() - 0.5 ||
      pixel->y > picture.height() - 0.5) {
    return std::nullopt;
  }
  return bilinear(picture, *pixel);
}

scene::Environment equirectangular(const common::ImageRgb8& picture) {
  scene::Environment environment{common::ImageRgb32f(picture.width(), picture.height()), true};
  std::transform(picture.pixels().begin(), picture.pixels().end(), environment.radiance.data(),
                 [](const common::Rgb8& pixel) { return scene::srgb_decode(pixel); });
  return environment;
}

}  // namespace

scene::Environment unroll_fisheye(const common::ImageRgb8& picture,
                                  const common::FisheyeModel& fisheye,
                                  const glm::dquat& world_from_fisheye) {
  scene::Environment environment{common::ImageRgb32f(kUnrolledWidth, kUnrolledHeight), true};
  common::Image<std::uint8_t> seen(kUnrolledWidth, kUnrolledHeight);
  const glm::dquat fisheye_from_world = glm::conjugate(glm::normalize(world_from_fisheye));
  glm::dvec3 sum(0.0);
  double solid_angle = 0.0;
  for (int y = 0; y < kUnrolledHeight; ++y) {
    const double weight = std::sin(std::numbers::pi * (y + 0.5) / kUnrolledHeight);
    for (int x = 0; x < kUnrolledWidth; ++x) {
      const glm::dvec3 direction(scene::environment_direction(environment, {x, y}));
      const auto color = seen_color(picture, fisheye, fisheye_from_world * direction);
      if (!color) continue;
      environment.radiance.at(x, y) = *color;
      seen.at(x, y) = 1;
      sum += weight * glm::dvec3(*color);
      solid_angle += weight;
    }
  }
  const glm::vec3 mean = solid_angle > 0.0 ? glm::vec3(sum / solid_angle) : glm::vec3(0.0f);
  for (std::size_t i = 0; i < seen.pixels().size(); ++i) {
    if (seen.pixels()[i] == 0) environment.radiance.pixels()[i] = mean;
  }
  return environment;
}

std::uint64_t environment_bytes(const EnvironmentInput& input) {
  try {
    const codec::JpegHeader header = codec::read_jpeg_header(input.image);
    const bool unrolled = input.projection == EnvironmentInput::Projection::Fisheye;
    const int width = unrolled ? kUnrolledWidth : header.width;
    const int height = unrolled ? kUnrolledHeight : header.height;
    return input.image.size() + sizeof(glm::vec3) * static_cast<std::uint64_t>(width) *
                                    static_cast<std::uint64_t>(height);
  } catch (const codec::JpegError&) {
    return 0;  // refused with a reason when it is applied
  }
}

scene::Environment make_environment(const EnvironmentInput& input) {
  const common::ImageRgb8 picture = codec::decode_jpeg(input.image);
  if (input.projection == EnvironmentInput::Projection::Equirectangular) {
    return equirectangular(picture);
  }
  if (const std::string defect = common::describe_defect(input.fisheye); !defect.empty()) {
    throw std::invalid_argument("fish-eye: " + defect);
  }
  if (picture.width() != input.fisheye.width || picture.height() != input.fisheye.height) {
    throw std::invalid_argument("fish-eye: the image is " + std::to_string(picture.width()) + "x" +
                                std::to_string(picture.height()) + ", its calibration is for " +
                                std::to_string(input.fisheye.width) + "x" +
                                std::to_string(input.fisheye.height));
  }
  return unroll_fisheye(picture, input.fisheye, input.world_from_fisheye);
}

}  // namespace amalgam::frame
