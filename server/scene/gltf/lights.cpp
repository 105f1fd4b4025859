#include "scene/gltf/lights.h"

#include <cmath>
#include <numbers>

namespace amalgam::scene {
namespace {

constexpr const char* kExtension = "KHR_lights_punctual";
constexpr double kAnything = 1e30;

std::optional<JsonCursor> extension_of(const JsonCursor& holder) {
  const auto extensions = holder.find("extensions");
  return extensions ? extensions->find(kExtension) : std::nullopt;
}

void read_cone(const JsonCursor& at, PunctualLight& light) {
  constexpr double kHalfPi = std::numbers::pi / 2.0;
  const auto spot = at.get("spot");
  const auto inner = spot.find("innerConeAngle"), outer = spot.find("outerConeAngle");
  const double outer_angle = outer ? outer->number(0.0, kHalfPi + 1e-6) : std::numbers::pi / 4.0;
  const double inner_angle = inner ? inner->number(0.0, kHalfPi) : 0.0;
  if (!(inner_angle < outer_angle)) spot.fail("innerConeAngle is not below outerConeAngle");
  light.cos_inner = static_cast<float>(std::cos(inner_angle));
  light.cos_outer = static_cast<float>(std::cos(outer_angle));
}

PunctualLight read_light(const JsonCursor& at) {
  PunctualLight light;
  const JsonCursor type = at.get("type");
  if (type.string() == "directional") {
    light.kind = PunctualLight::Kind::Directional;
  } else if (type.string() == "point") {
    light.kind = PunctualLight::Kind::Point;
  } else if (type.string() == "spot") {
    light.kind = PunctualLight::Kind::Spot;
    read_cone(at, light);
  } else {
    type.fail("'" + type.string() + "' is none of directional, point, spot");
  }
  const auto intensity = at.find("intensity"), color = at.find("color"), range = at.find("range");
  const double strength = intensity ? intensity->number(0.0, kAnything) : 1.0;
  const auto rgb = color ? color->numbers(3) : std::vector<double>(3, 1.0);
  for (int i = 0; i < 3; ++i) {
    const double component = rgb[static_cast<std::size_t>(i)];
    if (!(component >= 0.0)) color->fail("is negative");
    light.intensity[i] = static_cast<float>(component * strength);
  }
  if (range) {
    light.range = static_cast<float>(range->number(0.0, kAnything));
    if (!(light.range > 0.0f)) range->fail("is not above 0");
  }
  return light;
}

}  // namespace

std::vector<PunctualLight> read_lights(const JsonCursor& root) {
  std::vector<PunctualLight> lights;
  const auto extension = extension_of(root);
  if (!extension) return lights;
  for (const JsonCursor& at : extension->get("lights").filled_items()) {
    lights.push_back(read_light(at));
  }
  return lights;
}

std::optional<std::size_t> node_light(const JsonCursor& node, std::size_t light_count) {
  const auto extension = extension_of(node);
  if (!extension) return std::nullopt;
  const JsonCursor at = extension->get("light");
  const auto index = static_cast<std::size_t>(at.integer(0));
  if (index >= light_count)
    at.fail("there is no such light (the file has " + std::to_string(light_count) + ")");
  return index;
}

}  // namespace amalgam::scene
