#include "trace/radiance_limit.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/light/tone_map.h"
#include "trace/immersion.h"

namespace amalgam::trace {
namespace {

// Whether it may scatter light diffusely; clear glass and mirrors do not.
bool is_shaded(const scene::Material& material) {
  if (!scene::is_specular(material.kind)) return true;
  return material.kind == scene::MaterialKind::Dielectric &&
         (material.transmission < 1.0f || material.transmission_texture);
}

// The largest Phong radiance for an irradiance of 1 (scene/material.h), whatever the textures,
// which only make a factor smaller. A smaller roughness gives a brighter highlight.
glm::vec3 largest_response(const scene::Material& material) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const glm::vec3 color(material.base_color);
  if (material.kind == scene::MaterialKind::Dielectric &&
      material.roughness <= scene::kSmoothRoughness)
    return color / kPi;
  const bool textured = material.metallic_roughness_texture.has_value();
  const scene::PhongTerms terms =
      scene::phong_terms(color, material.metallic, textured ? 0.0f : material.roughness);
  if (!textured) {
    return terms.albedo / kPi + terms.specular * (terms.exponent + 2.0f) / (2.0f * kPi);
  }
  const glm::vec3 specular = glm::max(color, glm::vec3(scene::kDielectricF0));
  return color / kPi + specular * (terms.exponent + 2.0f) / (2.0f * kPi);
}

// The least distance from a point to an axis-aligned box, metres.
float distance_to(const scene::Bounds& box, const glm::vec3& point) {
  return glm::length(glm::max(glm::max(box.low - point, point - box.high), glm::vec3(0.0f)));
}

// How much brighter from outside a surface may be for lying in a medium (trace/immersion.h): the
// largest gain, of a white one, over n^2.
float largest_immersion(const scene::Material& material) {
  if (material.kind != scene::MaterialKind::Dielectric || material.thin) return 1.0f;
  const scene::PhongTerms white{.albedo = glm::vec3(1.0f)};
  return std::max(1.0f, immersion_gain(white, material.ior).x / (material.ior * material.ior));
}

glm::vec3 largest_irradiance(std::span<const scene::Light> lights, const scene::Bounds& box) {
  glm::vec3 sum(0.0f);
  for (const scene::Light& light : lights) {
    if (light.kind == scene::Light::Kind::Directional) {
      sum += light.intensity;
      continue;
    }
    const float distance = std::max(distance_to(box, light.position), scene::kMinLightDistance);
    sum += light.intensity / (distance * distance);
  }
  return sum;
}

}  // namespace

RadianceLimit find_radiance_limit(const EmbreeScene& scene, std::span<const scene::Light> lights,
                                  const scene::Environment* environment,
                                  const glm::vec3& largest_environment, bool has_camera_image) {
  RadianceLimit limit;
  if (environment != nullptr) {
    (environment->low_dynamic_range ? limit.environment : limit.radiance) = largest_environment;
  }
  const scene::Scene& data = scene.scene();
  float immersion = 1.0f;
  for (const scene::Material& material : data.materials) {
    immersion = std::max(immersion, largest_immersion(material));
  }
  for (std::uint32_t i = 0; i < data.instances.size(); ++i) {
    if (!scene.is_in_frame(i)) continue;
    const scene::Material& material = data.materials[data.instances[i].material];
    if (scene::is_specular(material.kind) && material.emission != glm::vec3(0.0f)) {
      limit.radiance = glm::vec3(kNoRadianceLimit);
    }
    if (!is_shaded(material)) continue;
    limit.radiance = glm::max(
        limit.radiance,
        immersion * (material.emission + largest_irradiance(lights, scene.world_bounds(i)) *
                                             largest_response(material)));
    if (has_camera_image && data.instances[i].role == scene::Role::Real) limit.looks_up = true;
  }
  // Sums of a frame may round upwards.
  constexpr float kRounding = 1.0001f;
  limit.radiance = glm::min(kRounding * limit.radiance, glm::vec3(kNoRadianceLimit));
  limit.environment *= kRounding;
  return limit;
}

RadianceLimit with_camera_image(RadianceLimit limit, const common::ImageRgb8& image,
                                const scene::ToneMap& tone_map) {
  if (!limit.looks_up) return limit;
  std::uint8_t brightest = 0;
  for (const common::Rgb8& pixel : image.pixels())
    brightest = std::max({brightest, pixel.r, pixel.g, pixel.b});
  const glm::vec3 camera =
      scene::inverse_tone_map(glm::vec3(scene::srgb_decode(brightest)), tone_map);
  limit.radiance = glm::max(limit.radiance, camera);
  return limit;
}

}  // namespace amalgam::trace
