// Glass that lets only a part through: rough where it is opaque, or polished all over.
#include <gtest/gtest.h>

#include <cmath>

#include "parity/closed_form_rig.h"

namespace amalgam::reference {
namespace {

using scene::Role;
using test_support::make_floor;
using test_support::make_glass;
using test_support::make_sun;

constexpr double kR = 0.04;  // of n = 1.5 at normal incidence
const Vec3 kEye(0.1, 2.0, 0.23);
const Vec3 kDown(0.0, -1.0, 0.0);
const Color kTint(0.5, 1.0, 0.75);
constexpr double kTransmission = 0.625 * 0.8;  // factor, texel
constexpr double kSun = 3.0;                   // irradiance, facing it

// metallic 0.5 x 0.4 (blue 102 of 255); roughness 1 x green.
scene::Material make_partly_opaque(std::uint8_t green, ClosedFormRig& rig) {
  scene::Material glass = make_glass(1.5f);
  glass.base_color = {0.5f, 1.0f, 0.75f, 1.0f};
  glass.transmission = 0.625f;
  glass.transmission_texture = add_texture(rig.scene, {204, 0, 0, 255});
  glass.metallic = 0.5f;
  glass.roughness = 1.0f;
  glass.metallic_roughness_texture = add_texture(rig.scene, {255, green, 102, 255});
  return glass;
}

// Radiance for irradiance 1 on a surface facing the light, seen along its mirrored direction.
Color highlight(double roughness, double cosine) {
  const double metallic = 0.5 * 0.4;
  const double exponent = 0.5 / std::pow(roughness, 4.0) - 0.5;
  const Color albedo = (1.0 - metallic) * 0.96 * kTint;
  const Color specular = glm::mix(Color(0.04), kTint, metallic);
  return cosine * (albedo / kPi + specular * ((exponent + 2.0) / (2.0 * kPi)));
}

// A sheet between a white sky, with the sun in the zenith, and a lamp that reflects nothing.
TEST(ReferenceRoughGlass, OpaqueShareHasAHighlightInPlaceOfAMirrorImage) {
  for (const bool thin : {true, false}) {
    for (const Role role : {Role::Virtual, Role::Real}) {
      ClosedFormRig rig;
      scene::Material glass = make_partly_opaque(153, rig);  // roughness 0.6
      glass.thin = thin;
      rig.add(make_floor(0.0f, 1.0f), glass, role);
      scene::Material lamp = make_lamp(glm::vec3(2.0f));
      lamp.metallic = 1.0f;
      rig.add(make_floor(-1.0f, 1.0f), lamp);
      rig.lights.push_back(make_sun({0.0f, 1.0f, 0.0f}));
      rig.set_environment(glm::vec3(1.0f));

      const double k_s = thin ? 2.0 * kR / (1.0 + kR) : kR;
      const Color sky(kTransmission * k_s);
      const double lamp_seen = thin ? 2.0 : 2.0 / (1.5 * 1.5);  // from outside of its medium
      const Color through = kTransmission * (1.0 - k_s) * kTint * lamp_seen;
      const Color back = (1.0 - kTransmission) * kSun * highlight(0.6, 1.0);
      const Sample sample = rig.trace(kEye, kDown);
      EXPECT_LT(glm::length(sample.mixed - (sky + through + back)), 1e-12) << thin;
      const Color real = sky + (role == Role::Real ? back : Color(0.0));
      EXPECT_LT(glm::length(sample.real - real), 1e-12) << thin;
    }
  }
}

// From within glass, 60 degrees off its surface's normal (the critical angle is 41.8). The light
// shines from within the glass too, along the mirrored ray.
TEST(ReferenceRoughGlass, ScattersUnderTotalReflectionToo) {
  const Vec3 up_and_right(std::sqrt(0.75), 0.5, 0.0);
  const Vec3 mirrored(std::sqrt(0.75), -0.5, 0.0);
  for (const bool rough : {true, false}) {
    ClosedFormRig rig;
    rig.add(make_floor(0.0f, 9.0f), make_partly_opaque(rough ? 153 : 26, rig));
    rig.lights.push_back(make_sun(glm::vec3(mirrored)));
    rig.set_environment(glm::vec3(1.0f));
    const Color rough_glass = kTransmission + (1.0 - kTransmission) * kSun * highlight(0.6, 0.5);
    const Color seen = rig.trace({0.1, -1.0, 0.23}, up_and_right).mixed;
    // The sun's direction has float's digits.
    EXPECT_LT(glm::length(seen - (rough ? rough_glass : Color(1.0))), 1e-6) << rough;
  }
}

TEST(ReferenceRoughGlass, BeginsAboveAFifth) {
  const auto seen = [](std::uint8_t green, float factor) {
    ClosedFormRig rig;
    scene::Material glass = make_partly_opaque(green, rig);
    glass.thin = true;
    glass.roughness = factor;
    rig.add(make_floor(0.0f, 1.0f), glass);
    rig.set_environment(glm::vec3(1.0f));  // below as well
    return rig.trace(kEye, kDown).mixed;
  };
  const double k_s = 2.0 * kR / (1.0 + kR);
  const Color through = kTransmission * (1.0 - k_s) * kTint;
  const Color smooth = k_s + through, rough = kTransmission * k_s + through;
  EXPECT_LT(glm::length(seen(51, 1.0f) - smooth), 1e-12);
  EXPECT_LT(glm::length(seen(255, 0.2f) - smooth), 1e-12);
  EXPECT_LT(glm::length(seen(52, 1.0f) - rough), 1e-12);
}

// All of it lets light through: there is nothing that could be rough.
TEST(ReferenceRoughGlass, OfClearGlassRoughnessChangesNothing) {
  for (const bool thin : {true, false}) {
    ClosedFormRig rig;
    scene::Material glass = make_glass(1.5f);
    glass.thin = thin;
    glass.roughness = 0.6f;
    rig.add(make_floor(0.0f, 1.0f), glass);
    rig.lights.push_back(make_sun({0.0f, 1.0f, 0.0f}));
    rig.set_environment(glm::vec3(1.0f));
    EXPECT_LT(glm::length(rig.trace(kEye, kDown).mixed - Color(1.0)), 1e-12) << thin;
  }
}

}  // namespace
}  // namespace amalgam::reference
