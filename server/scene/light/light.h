// A light for shading: one struct for environment lights and glTF punctual lights, in the world
// frame.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace amalgam::scene {

struct Light {
  enum class Kind : std::uint8_t { Directional, Point, Spot };
  Kind kind = Kind::Directional;
  // Unit. Directional: towards the light. Spot: against its axis.
  glm::vec3 to_light{0.0f, 1.0f, 0.0f};
  glm::vec3 position{0.0f};  // point and spot: metres
  // Directional: irradiance on a surface facing it (for an environment light, radiance x solid
  // angle). Point and spot: radiant intensity; irradiance is intensity / distance^2.
  glm::vec3 intensity{0.0f};
  float range = 0.0f;  // metres, 0 = unlimited; glTF's window max(min(1-(d/r)^4,1),0)
  float cos_inner = 1.0f, cos_outer = 0.0f;  // spot; glTF's smooth cone
  bool operator==(const Light&) const = default;
};

// Also in shaders (gl/shader_constants.h). The least distance to a light, so that irradiance stays
// finite (small enough for lamps in a scene of a millimetre), and the least cos_inner - cos_outer
// of a spot.
constexpr float kMinLightDistance = 1e-6f;  // metres
constexpr float kMinConeWidth = 0.001f;

// Unoccluded light at a point.
struct LightArrival {
  glm::vec3 to_light{0.0f};    // unit
  float distance = 0.0f;       // metres; infinity for directional lights
  glm::vec3 irradiance{0.0f};  // on a surface facing the light
};
LightArrival light_arrival(const Light& light, const glm::vec3& point);

}  // namespace amalgam::scene
