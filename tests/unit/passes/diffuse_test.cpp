#include "passes/raster/diffuse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "scene/texture_lookup.h"
#include "support/scene_builders.h"
#include "unit/passes/raster_rig.h"

namespace amalgam::passes {
namespace {

using namespace test_support;

// Eq. 4.6 in double, written from the formula in passes/raster/diffuse.h.
glm::dvec3 phong(const glm::dvec3& base_color, double metallic, double roughness,
                 const glm::dvec3& normal, const glm::dvec3& view, const glm::dvec3& to_light,
                 const glm::dvec3& irradiance) {
  const double cosine = glm::dot(normal, to_light);
  if (cosine <= 0.0) return glm::dvec3(0.0);
  const double alpha = roughness * roughness;
  const double exponent = 0.5 / (alpha * alpha) - 0.5;
  const glm::dvec3 specular = glm::mix(glm::dvec3(0.04), base_color, metallic);
  const glm::dvec3 albedo = base_color * (1.0 - metallic) * 0.96;
  const glm::dvec3 reflected = 2.0 * cosine * normal - to_light;
  const double lobe = std::pow(std::max(glm::dot(reflected, view), 0.0), exponent);
  return irradiance * cosine *
         (albedo / std::numbers::pi +
          specular * (exponent + 2.0) / (2.0 * std::numbers::pi) * lobe);
}

struct Camera {
  common::CameraModel model = make_pinhole(64, 48, 60.0);
  glm::dmat4 camera_from_world = look_at({0.1, 0.5, 0.4}, {0.02, 0.0, 0.0});
  glm::dvec3 eye() const { return glm::dvec3(common::rigid_inverse(camera_from_world)[3]); }
  // Where a pixel sees the plane y = 0.
  glm::dvec3 floor_point(int x, int y) const {
    const glm::dvec3 direction(
        common::rigid_inverse(camera_from_world) *
        glm::dvec4(common::pixel_direction(model, glm::dvec2(x, y)).value(), 0.0));
    return eye() - direction * (eye().y / direction.y);
  }
};

void expect_near(const glm::vec4& actual, const glm::dvec3& expected, double tolerance,
                 const char* what) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(actual[i], expected[i], tolerance * std::max(std::abs(expected[i]), 1e-3)) << what;
  }
}

TEST(DiffusePass, ShadesAQuadAsTheFormulaSays) {
  const Camera camera;
  const glm::vec3 color(0.8f, 0.5f, 0.2f);
  const scene::Light sun = make_sun({0.3f, 1.0f, -0.4f}, {3.0f, 2.0f, 1.0f});
  struct Case {
    float metallic, roughness;
  };
  for (const Case& c : {Case{0.0f, 1.0f}, Case{0.0f, 0.5f}, Case{0.4f, 0.6f}, Case{0.0f, 0.3f}}) {
    scene::Scene scene;
    scene::Material material = make_diffuse(color, c.roughness);
    material.metallic = c.metallic;
    material.emission = {0.1f, 0.0f, 0.02f};
    add_object(scene, make_floor(0.0f, 2.0f), material, scene::Role::Real);
    RasterRig rig(scene);
    const RasterFrame frame =
        rig.render(make_view(scene, camera.model, camera.camera_from_world, {sun}));
    for (int y = 0; y < 48; y += 5) {
      for (int x = 0; x < 64; x += 5) {
        const glm::dvec3 view = glm::normalize(camera.eye() - camera.floor_point(x, y));
        const glm::dvec3 expected =
            glm::dvec3(material.emission) +
            phong(glm::dvec3(color), c.metallic, c.roughness, {0, 1, 0}, view,
                  glm::normalize(glm::dvec3(0.3, 1.0, -0.4)), {3, 2, 1});
        expect_near(frame.mixed->at(x, y), expected, 1e-5, "mixed");
        expect_near(frame.real->at(x, y), expected, 1e-5, "real");
        EXPECT_EQ(frame.mixed->at(x, y).w, 0.0f);
        EXPECT_EQ(frame.real->at(x, y).w, 1.0f);
      }
    }
  }
}

TEST(DiffusePass, TakesPunctualLightsAsTheSceneDefinesThem) {
  const Camera camera;
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 2.0f), make_diffuse(glm::vec3(0.6f)), scene::Role::Real);
  scene::Light point = make_point_light({0.1f, 0.3f, 0.0f}, {0.2f, 0.3f, 0.4f});
  point.range = 0.8f;
  scene::Light spot = make_point_light({-0.2f, 0.4f, 0.1f}, {0.5f, 0.4f, 0.3f});
  spot.kind = scene::Light::Kind::Spot;
  spot.to_light = glm::normalize(glm::vec3(-0.3f, 1.0f, 0.2f));
  spot.cos_inner = 0.95f;
  spot.cos_outer = 0.7f;
  RasterRig rig(scene);
  for (const scene::Light& light : {point, spot}) {
    const RasterFrame frame =
        rig.render(make_view(scene, camera.model, camera.camera_from_world, {light}));
    double brightest = 0.0;
    for (int y = 0; y < 48; y += 5) {
      for (int x = 0; x < 64; x += 5) {
        const glm::dvec3 p = camera.floor_point(x, y);
        const scene::LightArrival arrival = scene::light_arrival(light, glm::vec3(p));
        const glm::dvec3 expected =
            phong(glm::dvec3(0.6f), 0.0, 1.0, {0, 1, 0}, glm::normalize(camera.eye() - p),
                  glm::dvec3(arrival.to_light), glm::dvec3(arrival.irradiance));
        expect_near(frame.mixed->at(x, y), expected, 3e-5, "light");
        brightest = std::max(brightest, expected.x);
      }
    }
    EXPECT_GT(brightest, 0.1);
  }
}

// Both sides are lit as if their normal pointed to the camera, also of an instance that mirrors.
TEST(DiffusePass, TurnsNormalsToTheCamera) {
  const Camera camera;
  for (const float mirror : {1.0f, -1.0f}) {
    for (const float flip : {1.0f, -1.0f}) {
      scene::Scene scene;
      const glm::mat4 place = glm::scale(glm::mat4(1.0f), {mirror * 0.5f, flip * 2.0f, 0.7f});
      add_object(scene, make_floor(0.0f, 4.0f), make_diffuse(glm::vec3(0.6f)), scene::Role::Virtual,
                 place);
      RasterRig rig(scene);
      const glm::vec3 to_light(0.3f, 1.0f, -0.4f);
      const RasterFrame lit = rig.render(
          make_view(scene, camera.model, camera.camera_from_world, {make_sun(to_light)}));
      const glm::dvec3 view = glm::normalize(camera.eye() - camera.floor_point(32, 24));
      expect_near(lit.mixed->at(32, 24),
                  phong(glm::dvec3(0.6f), 0.0, 1.0, {0, 1, 0}, view,
                        glm::normalize(glm::dvec3(to_light)), glm::dvec3(3.0)),
                  1e-5, "lit");
      EXPECT_EQ(lit.mixed->at(32, 24).w, 1.0f);
      EXPECT_EQ(lit.real->at(32, 24), glm::vec4(0.0f));  // nothing real there
      const RasterFrame dark = rig.render(
          make_view(scene, camera.model, camera.camera_from_world, {make_sun(-to_light)}));
      EXPECT_EQ(glm::vec3(dark.mixed->at(32, 24)), glm::vec3(0.0f));
    }
  }
}

TEST(DiffusePass, InterpolatesNormalsThroughNonUniformScale) {
  // An ellipsoid; its exact normal is the gradient of its equation.
  scene::Scene scene;
  const glm::vec3 axes(0.2f, 0.1f, 0.15f);
  add_object(scene, make_sphere({0, 0, 0}, 1.0f, 256, 128), make_diffuse(glm::vec3(0.6f)),
             scene::Role::Virtual, glm::scale(glm::mat4(1.0f), axes));
  const glm::dvec3 eye(0.0, 0.6, 0.4);
  const common::CameraModel camera = make_pinhole(64, 64, 100.0);
  const glm::dmat4 camera_from_world = look_at(eye, {0, 0, 0});
  RasterRig rig(scene);
  const scene::Light sun = make_sun({0.5f, 1.0f, 0.5f});
  const RasterFrame frame = rig.render(make_view(scene, camera, camera_from_world, {sun}));
  const glm::dmat4 world_from_camera = common::rigid_inverse(camera_from_world);
  for (const glm::ivec2& pixel : {glm::ivec2(32, 32), glm::ivec2(40, 28), glm::ivec2(25, 36)}) {
    const glm::dvec3 d(world_from_camera *
                       glm::dvec4(common::pixel_direction(camera, glm::dvec2(pixel)).value(), 0.0));
    const glm::dvec3 o = eye / glm::dvec3(axes), v = d / glm::dvec3(axes);
    const double a = glm::dot(v, v), b = glm::dot(o, v), c = glm::dot(o, o) - 1.0;
    const glm::dvec3 p = eye + d * ((-b - std::sqrt(b * b - a * c)) / a);
    const glm::dvec3 normal = glm::normalize(p / (glm::dvec3(axes) * glm::dvec3(axes)));
    expect_near(frame.mixed->at(pixel.x, pixel.y),
                phong(glm::dvec3(0.6f), 0.0, 1.0, normal, glm::normalize(eye - p),
                      glm::normalize(glm::dvec3(0.5, 1.0, 0.5)), glm::dvec3(3.0)),
                1e-3, "ellipsoid");  // 256 facets around: 1e-4 of the radius
  }
}

TEST(DiffusePass, ReadsTexturesAsTheTracerDoes) {
  const Camera camera;
  for (const scene::Wrap wrap : {scene::Wrap::Repeat, scene::Wrap::Mirror, scene::Wrap::Clamp}) {
    scene::Scene scene;
    scene::Texture texture;
    texture.texels = common::ImageRgba8(7, 5);
    unsigned noise = 1;
    for (common::Rgba8& texel : texture.texels.pixels()) {
      for (int i = 0; i < 3; ++i) {
        noise = noise * 1664525u + 1013904223u;
        texel[i] = static_cast<std::uint8_t>(noise >> 24);
      }
      texel.w = 255;
    }
    texture.wrap_u = wrap;
    texture.wrap_v = scene::Wrap::Mirror;
    scene.textures.push_back(texture);
    scene::Material material = make_diffuse(glm::vec3(0.9f, 0.8f, 0.7f));
    material.base_color_texture = 0;
    scene::Mesh floor = make_floor(0.0f, 2.0f);
    for (glm::vec2& uv : floor.uvs) uv = 16.0f * uv - 7.3f;  // a texel is some pixels wide
    add_object(scene, floor, material, scene::Role::Real);
    RasterRig rig(scene);
    const RasterFrame frame =
        rig.render(make_view(scene, camera.model, camera.camera_from_world, {make_sun({0, 1, 0})}));
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) {
        const glm::dvec3 p = camera.floor_point(x, y);
        const glm::dvec2 uv(16.0 * (p.x + 2.0) / 4.0 - 7.3, 16.0 * (p.z + 2.0) / 4.0 - 7.3);
        const glm::vec3 texel(scene::sample_color_texture(texture, glm::vec2(uv)));
        const glm::dvec3 expected =
            phong(glm::dvec3(texel * glm::vec3(material.base_color)), 0.0, 1.0, {0, 1, 0},
                  glm::normalize(camera.eye() - p), {0, 1, 0}, glm::dvec3(3.0));
        // uv reaches 8 and has 6e-7 of rounding, times 7 texels, times differences of 1.
        expect_near(frame.mixed->at(x, y), expected, 1e-4, "texture");
      }
    }
  }
}

}  // namespace
}  // namespace amalgam::passes
