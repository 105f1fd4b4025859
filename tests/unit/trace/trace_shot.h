// One shot of a small scene with all the tracer's knobs, for tests that compare what is seen with a
// closed form.
//
// The middle ray of an image of odd size goes from the eye to the target exactly.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "scene/light/environment.h"
#include "scene/light/light.h"
#include "scene/scene.h"
#include "support/scene_builders.h"
#include "trace/tracer.h"

namespace amalgam::trace {

// Every instance where the scene has it.
scene::AnchoredScene anchor_all(const scene::Scene& scene);

scene::Environment constant_environment(float radiance, bool low_dynamic_range = false);

// Sends this radiance to all sides and reflects nothing.
scene::Material emitter(float radiance);

struct Shot {
  glm::dvec3 eye{0, 0, 2}, target{0, 0, 0};
  TraceSettings settings{};
  const scene::Environment* environment = nullptr;  // null: black
  std::vector<scene::Light> lights{};
  const common::ImageRgb8* camera_image = nullptr;
  int width = 9, height = 9, samples_per_side = 1;
  double focal_length = 200.0;
  float exposure = 1.0f;
  scene::RealSurfaces real_surfaces = scene::RealSurfaces::Ratio;
  bool keep_provenance = false;
};

TraceResult trace_shot(const scene::Scene& scene, const Shot& shot);

// I_m in the middle of the image.
glm::vec3 centre(const TraceResult& result);

// I_m of a single ray from eye towards target.
glm::vec3 trace_ray(const scene::Scene& scene, const glm::dvec3& eye, const glm::dvec3& target,
                    const TraceSettings& settings);

}  // namespace amalgam::trace
