// Small worlds for holding the reference to closed forms: one ray, looked at as a sample.
#pragma once

#include <span>
#include <vector>

#include "support/reference/media_around.h"
#include "support/reference/reference_renderer.h"
#include "support/scene_builders.h"

namespace amalgam::reference {

// A scene under construction, seen from anywhere along single rays. Everything stands in the world
// frame.
struct ClosedFormRig {
  scene::Scene scene;
  std::vector<Ball> balls;  // their object is filled in by add_ball()
  std::vector<Object> ball_objects;
  std::vector<scene::Light> lights;
  TraceSettings settings{.max_depth = 10, .importance_cutoff = 0.0, .fresnel = Fresnel::Schlick};
  const CameraView* camera_view = nullptr;

  scene::Instance& add(scene::Mesh mesh, scene::Material material,
                       scene::Role role = scene::Role::Virtual) {
    return test_support::add_object(scene, std::move(mesh), std::move(material), role);
  }

  void add_ball(const Vec3& centre, double radius, const scene::Material& material,
                scene::Role role = scene::Role::Virtual) {
    balls.push_back({centre, radius, 0});
    ball_objects.push_back({material, 1000 + static_cast<std::uint32_t>(balls.size()), role, 0.0});
  }

  // Light of this radiance from everywhere.
  void set_environment(const glm::vec3& radiance, bool low_dynamic_range = false) {
    scene.environment = scene::Environment{common::ImageRgb32f(8, 4, radiance), low_dynamic_range};
  }

  scene::AnchoredScene anchored() const {
    scene::AnchoredScene result;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
      result.instances.push_back({i, scene.instances[i].anchor_from_mesh});
    }
    return result;
  }

  World world() const {
    Geometry geometry = make_geometry(scene, anchored());
    for (std::size_t i = 0; i < balls.size(); ++i) {
      Ball ball = balls[i];
      ball.object = static_cast<std::uint32_t>(geometry.objects.size());
      geometry.balls.push_back(ball);
      geometry.objects.push_back(ball_objects[i]);
    }
    return World(std::move(geometry), scene.textures);
  }

  // spread: how fast the ray's cone widens, which decides on the textures' level of detail.
  Sample trace(const Vec3& origin, const Vec3& direction, double spread = 0.0) const {
    const World surfaces = world();
    const Whitted tracer({surfaces, lights, scene.environment ? &*scene.environment : nullptr,
                          camera_view, settings, media_around(surfaces, origin)});
    Decisions decisions;
    return tracer.trace(
        {.origin = origin, .direction = glm::normalize(direction), .spread = spread}, decisions);
  }
};

// Of one texel; returns its index.
inline std::uint32_t add_texture(scene::Scene& scene, const common::Rgba8& texel) {
  scene::Texture texture;
  texture.texels = common::ImageRgba8(1, 1, texel);
  scene.textures.push_back(std::move(texture));
  return static_cast<std::uint32_t>(scene.textures.size() - 1);
}

// A quad that shines with this radiance and reflects nothing.
inline scene::Material make_lamp(const glm::vec3& radiance = glm::vec3(1.0f)) {
  scene::Material material = test_support::make_diffuse(glm::vec3(0.0f));
  material.emission = radiance;
  return material;
}

}  // namespace amalgam::reference
