// The camera's side: look-ups (eq. 4.10, 4.11), the lens, curves, pictures and the composite.
#include <gtest/gtest.h>

#include <cmath>

#include "parity/closed_form_rig.h"
#include "support/reference/color_curves.h"
#include "support/reference/lens.h"
#include "support/reference/pictures.h"

namespace amalgam::reference {
namespace {

using scene::Role;
using test_support::look_at;
using test_support::make_box;
using test_support::make_diffuse;
using test_support::make_floor;
using test_support::make_mirror;
using test_support::make_pinhole;
using test_support::make_quad;

common::ImageRgb8 striped_image(int width, int height) {
  common::ImageRgb8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = {40 + (3 * x) % 200, 40 + (5 * y) % 200, 40 + (2 * x + y) % 200};
    }
  }
  return image;
}

// A real floor seen from above, a virtual mirror standing on it.
struct MirrorOnFloor {
  ClosedFormRig rig;
  common::ImageRgb8 image = striped_image(80, 60);
  ReferenceRequest request;

  MirrorOnFloor() {
    rig.add(make_floor(0.0f, 9.0f), make_diffuse(glm::vec3(0.5f)), Role::Real);
    rig.add(make_quad({0.0f, 0.5f, -1.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}), make_mirror());
    request.camera = make_pinhole(80, 60, 60.0);
    request.anchored = rig.anchored();
    request.anchored.camera_from_world = look_at({0.1, 2.0, 2.0}, {0.0, 0.3, -0.5});
    request.camera_image = &image;
    request.response.exposure = 0.7;
    request.lights = {test_support::make_sun({0.0f, 0.5f, 1.0f})};
  }
  ReferenceImages render() const { return render_reference(rig.world(), nullptr, request); }
};

TEST(ReferenceCamera, MirrorReturnsTheCamerasOwnColor) {
  const MirrorOnFloor setup;
  const ReferenceImages images = setup.render();
  const glm::dmat4 camera_from_world = setup.request.anchored.camera_from_world;
  const glm::dmat4 world_from_camera = glm::inverse(camera_from_world);
  const Vec3 eye(world_from_camera[3]);
  int compared = 0;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 80; ++x) {
      if (images.virtual_mask.at(x, y) == 0) continue;
      // The mirror lies in z = -1: its image of the eye is at (x, y, -2 - z).
      const Vec3 direction =
          glm::dmat3(world_from_camera) * pinhole_direction(setup.request.camera, {x, y});
      const Vec3 mirrored_eye(eye.x, eye.y, -2.0 - eye.z);
      const Vec3 mirrored_direction(direction.x, direction.y, -direction.z);
      const Vec3 on_floor =
          mirrored_eye - mirrored_direction * (mirrored_eye.y / mirrored_direction.y);
      const auto pixel =
          lens_project(setup.request.camera, transform_point(camera_from_world, on_floor));
      ASSERT_TRUE(pixel);
      if (border_trust(setup.request.camera, *pixel) < 1.0) continue;
      const Color expected = sample_camera_image(setup.image, *pixel);
      EXPECT_LT(glm::length(Color(images.layers.over.at(x, y)) - expected), 1e-9);
      ++compared;
    }
  }
  EXPECT_GT(compared, 200);
}

TEST(ReferenceCamera, NothingVirtualChangesNothing) {
  MirrorOnFloor setup;
  for (scene::Instance& instance : setup.rig.scene.instances) instance.role = Role::Real;
  for (const int samples : {1, 3}) {
    setup.request.samples_per_side = samples;
    const ReferenceImages images = setup.render();
    for (const Color& difference : images.layers.difference.pixels()) {
      EXPECT_EQ(difference, Color(0.0));
    }
    EXPECT_EQ(images.composite, setup.image);
  }
}

TEST(ReferenceCamera, NothingVirtualChangesNothingBehindALensEither) {
  MirrorOnFloor setup;
  for (scene::Instance& instance : setup.rig.scene.instances) instance.role = Role::Real;
  setup.request.camera.distortion = {-0.2, 0.05, 0.001, -0.001};
  EXPECT_EQ(setup.render().composite, setup.image);
}

double trust_at(const ClosedFormRig& rig, const CameraView& view, const Vec3& point,
                const Vec3& facing) {
  return look_up(rig.world(), view, point, facing).trust;
}

// Visible, hidden by something real, hidden by something virtual, behind the camera, seen from its
// back.
TEST(ReferenceCamera, LooksUpOnlyWhatTheCameraSees) {
  const MirrorOnFloor setup;
  CameraView view{&setup.image, setup.request.camera, look_at({0.0, 2.0, 0.0}, {0.0, 0.0, -1.0}),
                  1.0};
  const Vec3 point(0.1, 0.0, -1.03), up(0.0, 1.0, 0.0);
  ClosedFormRig floor;
  floor.add(make_floor(0.0f, 9.0f), make_diffuse(glm::vec3(0.5f)), Role::Real);
  EXPECT_EQ(trust_at(floor, view, point, up), 1.0);
  EXPECT_EQ(trust_at(floor, view, point, -up), 0.0);
  EXPECT_EQ(trust_at(floor, view, {0.1, 0.0, 5.0}, up), 0.0);   // behind
  EXPECT_EQ(trust_at(floor, view, {5.0, 0.0, -1.0}, up), 0.0);  // beside
  for (const Role role : {Role::Real, Role::Virtual}) {
    ClosedFormRig hidden = floor;
    hidden.add(make_box({-0.2f, 0.3f, -0.9f}, {0.4f, 1.3f, -0.3f}), make_mirror(), role);
    EXPECT_EQ(trust_at(hidden, view, point, up), role == Role::Real ? 0.0 : 1.0);
  }
}

TEST(ReferenceCamera, TrustRisesFromTheBorder) {
  const common::CameraModel camera = make_pinhole(200, 100, 100.0);  // band: 4 pixels
  EXPECT_EQ(border_trust(camera, {0.0, 50.0}), 0.0);
  EXPECT_EQ(border_trust(camera, {-3.0, 50.0}), 0.0);
  EXPECT_NEAR(border_trust(camera, {100.0, 97.0}), 0.5, 1e-12);
  EXPECT_NEAR(border_trust(camera, {198.0, 50.0}), 0.15625, 1e-12);
  EXPECT_EQ(border_trust(camera, {4.0, 50.0}), 1.0);
}

TEST(ReferenceCamera, LensGoesBothWays) {
  common::CameraModel camera = make_pinhole(640, 480, 500.0);
  camera.distortion = {-0.28,  0.09,  0.0012, -0.0007, 0.003,  0.01,
                       -0.004, 0.001, 0.0005, -0.0002, 0.0003, 0.0001};
  const common::CameraModel ideal = make_pinhole(640, 480, 500.0);
  for (int y = 0; y < 480; y += 37) {
    for (int x = 0; x < 640; x += 41) {
      const auto seen = ideal_pixel(camera, ideal, {x, y});
      ASSERT_TRUE(seen);
      const auto back = lens_project(camera, 3.0 * pinhole_direction(ideal, *seen));
      ASSERT_TRUE(back);
      EXPECT_LT(glm::length(*back - Vec2(x, y)), 1e-6);
    }
  }
  // Radial distortion alone, by hand: r (1 - 0.1 r^2) has its fold at r^2 = 10 / 3.
  camera.distortion = {-0.1};
  EXPECT_NEAR(lens_distort(camera, {0.6, 0.8}).x, 0.6 * 0.9, 1e-15);
  EXPECT_TRUE(lens_project(camera, {1.8, 0.0, 1.0}));
  EXPECT_FALSE(lens_project(camera, {1.9, 0.0, 1.0}));
  EXPECT_FALSE(lens_project(camera, {0.0, 0.0, 0.0}));
  EXPECT_FALSE(lens_project(camera, {0.1, 0.1, -1.0}));
}

TEST(ReferenceCamera, CurvesAreInvertible) {
  for (int byte = 0; byte < 256; ++byte) {
    EXPECT_EQ(srgb_encode_byte(srgb_decode_byte(static_cast<std::uint8_t>(byte))), byte);
  }
  for (const double exposure : {0.1, 1.0, 30.0}) {
    for (double d = 0.0; d < 0.99; d += 0.01) {
      EXPECT_NEAR(tone_map(inverse_tone_map(Color(d), {exposure}), {exposure}).r, d, 1e-14);
    }
  }
  EXPECT_NEAR(tone_map(Color(1.0), {1.0}).g, 0.5, 1e-15);
  EXPECT_EQ(tone_map(Color(0.25), {2.0, true}).g, 0.5);
  EXPECT_EQ(tone_map(Color(3.0), {2.0, true}).g, 1.0);
  EXPECT_NEAR(srgb_decode(0.5), 0.21404114048223255, 1e-12);
}

TEST(ReferenceCamera, EnvironmentOrientation) {
  scene::Environment map{common::ImageRgb32f(8, 4, glm::vec3(0.0f)), false};
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) map.radiance.at(x, y) = {x, y, 1.0f};
  }
  // Texel centres have integer coordinates: the middle of the picture is (3.5, 1.5).
  const auto position = [&](const Vec3& direction) {
    return Vec2(environment_towards(map, direction));
  };
  EXPECT_LT(glm::length(position({0.0, 0.0, 1.0}) - Vec2(3.5, 1.5)), 1e-12);
  EXPECT_LT(glm::length(position({1.0, 0.0, 0.0}) - Vec2(1.5, 1.5)), 1e-12);
  EXPECT_LT(glm::length(position({-1.0, 0.0, 0.0}) - Vec2(5.5, 1.5)), 1e-12);
  EXPECT_NEAR(position({0.0, 1.0, 0.0}).y, 0.0, 1e-12);
  EXPECT_NEAR(position({0.0, -1.0, 0.0}).y, 3.0, 1e-12);
  EXPECT_NEAR(position({0.0, 0.0, -1.0}).x, 3.5, 1e-12);  // half of texel 7 and half of texel 0
}

TEST(ReferenceCamera, TextureWrapping) {
  scene::Texture texture;
  texture.texels = common::ImageRgba8(2, 1);
  texture.wrap_v = scene::Wrap::Clamp;
  texture.texels.at(0, 0) = {0, 0, 0, 0};
  texture.texels.at(1, 0) = {255, 255, 255, 255};
  const auto red = [&](double u) {
    return sample_texture(texture, TextureContent::Color, {u, 0.3}).r;
  };
  EXPECT_NEAR(red(0.25), 0.0, 1e-15);
  EXPECT_NEAR(red(0.75), 1.0, 1e-15);
  EXPECT_NEAR(red(0.5), 0.5, 1e-15);
  EXPECT_NEAR(red(-1.0), 0.5, 1e-15);
  EXPECT_NEAR(red(1.25), 0.0, 1e-15);
  texture.wrap_u = scene::Wrap::Mirror;
  EXPECT_NEAR(red(1.25), 1.0, 1e-15);
  EXPECT_NEAR(red(1.75), 0.0, 1e-15);
  EXPECT_NEAR(red(-0.25), 0.0, 1e-15);
  texture.wrap_u = scene::Wrap::Clamp;
  EXPECT_NEAR(red(1.9), 1.0, 1e-15);
  EXPECT_NEAR(red(-7.0), 0.0, 1e-15);
}

TEST(ReferenceCamera, HalfCoveredPixelHasNoRim) {
  // A white-hot object over the left half of the only pixel, on a dark camera image.
  ClosedFormRig rig;
  rig.add(make_quad({-1.0f, 0.0f, -1.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}),
          make_lamp(glm::vec3(1000.0f)));
  ReferenceRequest request;
  const common::ImageRgb8 image(1, 1, common::Rgb8(0));
  request.camera = make_pinhole(1, 1, 1.0);
  request.anchored = rig.anchored();
  request.anchored.camera_from_world = look_at({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0});
  request.camera_image = &image;
  request.samples_per_side = 2;
  const ReferenceImages images = render_reference(rig.world(), nullptr, request);
  EXPECT_NEAR(images.layers.over.at(0, 0).a, 0.5, 1e-15);
  EXPECT_NEAR(images.layers.over.at(0, 0).r, 0.5 * 1000.0 / 1001.0, 1e-12);
  EXPECT_EQ(images.composite.at(0, 0).r, srgb_encode_byte(0.5 * 1000.0 / 1001.0));
}

}  // namespace
}  // namespace amalgam::reference
