#include "unit/trace/trace_shot.h"

namespace amalgam::trace {

scene::AnchoredScene anchor_all(const scene::Scene& scene) {
  scene::AnchoredScene anchored;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    anchored.instances.push_back({i, scene.instances[i].anchor_from_mesh});
  }
  return anchored;
}

scene::Environment constant_environment(float radiance, bool low_dynamic_range) {
  return {common::ImageRgb32f(8, 4, glm::vec3(radiance)), low_dynamic_range};
}

scene::Material emitter(float radiance) {
  scene::Material material = test_support::make_diffuse(glm::vec3(0.0f));
  material.metallic = 1.0f;  // a black dielectric would still shine a little
  material.emission = glm::vec3(radiance);
  return material;
}

TraceResult trace_shot(const scene::Scene& scene, const Shot& shot) {
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  const common::CameraModel camera =
      test_support::make_pinhole(shot.width, shot.height, shot.focal_length);
  const glm::dmat4 camera_from_world = test_support::look_at(shot.eye, shot.target);
  CameraView lookup{.camera = camera, .camera_from_world = camera_from_world, .ideal = camera};
  return trace({.scene = embree,
                .lights = shot.lights,
                .environment = shot.environment,
                .camera = camera,
                .camera_from_world = camera_from_world,
                .samples_per_side = shot.samples_per_side,
                .lookup = shot.camera_image != nullptr ? &lookup : nullptr,
                .camera_image = shot.camera_image,
                .tone_map = scene::tone_map_of(shot.exposure),
                .real_surfaces = shot.real_surfaces,
                .settings = shot.settings,
                .keep_images = true,
                .keep_provenance = shot.keep_provenance});
}

glm::vec3 centre(const TraceResult& result) {
  const auto& mixed = result.images->mixed;
  return mixed.at(mixed.width() / 2, mixed.height() / 2);
}

glm::vec3 trace_ray(const scene::Scene& scene, const glm::dvec3& eye, const glm::dvec3& target,
                    const TraceSettings& settings) {
  return centre(trace_shot(
      scene, {.eye = eye, .target = target, .settings = settings, .width = 1, .height = 1}));
}

}  // namespace amalgam::trace
