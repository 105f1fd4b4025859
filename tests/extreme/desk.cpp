#include "extreme/desk.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <iostream>

#include "parity/parity_row.h"
#include "support/compare_images.h"
#include "support/scene_builders.h"

namespace amalgam::extreme {
namespace {

using scene::Role;
using namespace test_support;

// The rasteriser's depth knows one point a pixel: look-ups past things smaller than that may see
// what the reference's rays find hidden. Shadows differ in pixels at their edges.
constexpr double kMostLookUpsWrong = 0.01, kMostCompositeWrong = 0.02;

scene::Environment soft_environment() {
  scene::Environment environment{common::ImageRgb32f(16, 8), false};
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      const float around = 0.5f + 0.5f * std::sin(static_cast<float>(x) * 0.3926991f);
      environment.radiance.at(x, y) = {0.3f + 0.5f * around, 0.9f - 0.08f * static_cast<float>(y),
                                       0.6f - 0.3f * around};
    }
  }
  return environment;
}

glm::vec3 sized(double size, const glm::dvec3& p) {
  return glm::vec3(size * p);
}

}  // namespace

parity::ParityCase make_desk(double size) {
  parity::ParityCase desk;
  desk.name = "desk of " + std::to_string(size) + " m";
  scene::Scene& scene = desk.scene;
  scene.world.marker = 40;
  const auto s = static_cast<float>(size);
  add_object(scene, make_floor(0.0f, s), make_diffuse({0.6f, 0.55f, 0.5f}), Role::Real);
  add_object(scene, make_box(sized(size, {0.1, 0.002, -0.3}), sized(size, {0.3, 0.15, -0.15})),
             make_diffuse({0.3f, 0.5f, 0.7f}), Role::Real);
  add_object(scene, make_box(sized(size, {-0.4, 0.002, -0.2}), sized(size, {-0.25, 0.2, -0.05})),
             make_diffuse({0.8f, 0.3f, 0.2f}, 0.5f), Role::Virtual);
  add_object(scene, make_sphere(sized(size, {0.15, 0.13, 0.05}), 0.12f * s, 24, 12),
             make_mirror({0.9f, 0.85f, 0.8f}), Role::Virtual);
  add_object(scene, make_sphere(sized(size, kGlassMiddle), static_cast<float>(kGlassRadius) * s),
             make_glass(1.5f, glm::vec3(1.0f, 0.5f, 0.2f) / s), Role::Virtual);
  add_object(scene, make_sphere(sized(size, kGlassMiddle), static_cast<float>(kBubbleRadius) * s),
             make_glass(1.0f), Role::Virtual);
  scene::PunctualLight lamp;
  lamp.kind = scene::PunctualLight::Kind::Point;
  lamp.intensity = glm::vec3(0.5f, 0.45f, 0.4f) * (s * s);
  lamp.anchor_from_light = glm::translate(glm::mat4(1.0f), sized(size, {0.3, 0.9, 0.4}));
  scene.punctual_lights.push_back(lamp);
  scene.environment = soft_environment();
  set_camera(desk, make_pinhole(kDeskWidth, kDeskHeight, kDeskWidth));
  // Not in the plane of any face: which side of it the camera sees would be chance.
  place_camera(desk, size, {0.11, 0.55, 0.8}, {0.0, 0.1, 0.0});
  return desk;
}

void place_camera(parity::ParityCase& desk, double size, const glm::dvec3& eye,
                  const glm::dvec3& target) {
  desk.poses = {make_pose(desk.scene.world.marker, look_at(size * eye, size * target))};
}

void set_camera(parity::ParityCase& desk, const common::CameraModel& camera) {
  desk.camera = camera;
  desk.camera_image = parity::make_camera_image(camera.width, camera.height);
}

parity::Rendering render(const parity::ParityCase& desk, frame::RendererMode mode) {
  frame::RendererSettings settings;
  settings.mode = mode;
  settings.trace_shadow_edges = true;
  return parity::render(desk, settings);
}

void expect_right(const parity::ParityCase& desk) {
  reference::ReferenceRequest request = parity::make_reference_request(desk);
  request.find_grazing = true;
  expect_close(desk, reference::render_reference(desk.scene, request));
}

void expect_close(const parity::ParityCase& desk, const reference::ReferenceImages& expected) {
  const auto& mask = expected.virtual_mask.pixels();
  EXPECT_NE(std::count(mask.begin(), mask.end(), 1), 0) << desk.name << ": nothing is in view";
  for (const auto mode : {frame::RendererMode::Raytrace, frame::RendererMode::Hybrid}) {
    const parity::ParityRow row = parity::compare_rendering(render(desk, mode), expected, mode);
    std::cout << parity::table_line(desk, mode, row);
    const auto pixels = static_cast<double>(row.pixels);
    const bool traced = mode == frame::RendererMode::Raytrace;
    EXPECT_EQ(row.nonfinite, 0u) << desk.name;
    EXPECT_LE(static_cast<double>(row.traced_wrong), traced ? 0.0 : kMostLookUpsWrong * pixels)
        << desk.name << ' ' << parity::mode_name(mode) << row.worst;
    EXPECT_LE(static_cast<double>(row.composite_wrong), kMostCompositeWrong * pixels)
        << desk.name << ' ' << parity::mode_name(mode);
  }
}

void expect_both_alike(const parity::ParityCase& desk) {
  const parity::Rendering traced = render(desk, frame::RendererMode::Raytrace);
  const parity::Rendering hybrid = render(desk, frame::RendererMode::Hybrid);
  EXPECT_EQ(traced.statistics.nonfinite, 0u) << desk.name;
  EXPECT_EQ(hybrid.statistics.nonfinite, 0u) << desk.name;
  const double pixels = desk.camera.width * desk.camera.height;
  const Tolerance tolerance = {3.0, 0.1, "1/255: rounding to bytes; shadow maps at edges",
                               static_cast<std::size_t>(kMostCompositeWrong * pixels)};
  EXPECT_TRUE(
      images_agree(desk.name, as_floats(hybrid.composite), as_floats(traced.composite), tolerance));
}

}  // namespace amalgam::extreme
