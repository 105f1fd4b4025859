#include "scene/gltf/lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/gltf/check/limits.h"

namespace amalgam::scene {
namespace {

constexpr const char* kExtension = "KHR_lights_punctual";

std::optional<JsonCursor> extension_of(const JsonCursor& holder) {
  const auto extensions = holder.find("extensions");
  return extensions ? extensions->find(kExtension) : std::nullopt;
}

class LightReader {
 public:
  explicit LightReader(std::vector<std::string>* notes) : notes_(notes) {}

  PunctualLight read(const JsonCursor& at) const {
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
    const auto intensity = at.find("intensity"), color = at.find("color");
    const double strength = intensity ? intensity->number(0.0, kMaxQuantity) : 1.0;
    const auto rgb = color ? color->numbers(3) : std::vector<double>(3, 1.0);
    bool is_clamped = false;
    for (int i = 0; i < 3; ++i) {
      const double component = rgb[static_cast<std::size_t>(i)];
      if (!(component >= 0.0)) color->fail("is negative");
      const double product = component * strength;
      light.intensity[i] = static_cast<float>(std::min(product, kMaxProduct));
      is_clamped = is_clamped || product > kMaxProduct;
    }
    if (is_clamped) note(at, "its color times intensity is brought to 1e12");
    if (const auto range = at.find("range")) {
      light.range = static_cast<float>(range->number(0.0, kMaxQuantity));
      if (light.range == 0.0f) note(*range, "is 0, read as unlimited");
    }
    return light;
  }

  void note(const JsonCursor& at, const std::string& what) const {
    if (notes_) notes_->push_back(at.path() + ": " + what);
  }

 private:
  // Equal angles are a hard edge: Blender's spot with a blend of 0.
  void read_cone(const JsonCursor& at, PunctualLight& light) const {
    constexpr double kHalfPi = std::numbers::pi / 2.0, kRounding = 1e-3;
    const auto spot = at.find("spot");
    if (!spot) note(at, "is a spot light without 'spot', read with its default angles");
    const auto inner = spot ? spot->find("innerConeAngle") : std::nullopt;
    const auto outer = spot ? spot->find("outerConeAngle") : std::nullopt;
    const double outer_angle =
        outer ? outer->number(0.0, kHalfPi + kRounding) : std::numbers::pi / 4.0;
    const double inner_angle = inner ? inner->number(0.0, kHalfPi + kRounding) : 0.0;
    if (inner_angle >= outer_angle)
      note(*spot, "innerConeAngle is not below outerConeAngle, its cone has a hard edge");
    light.cos_inner = static_cast<float>(std::cos(std::min(inner_angle, outer_angle)));
    light.cos_outer = static_cast<float>(std::cos(outer_angle));
  }

  std::vector<std::string>* notes_;
};

}  // namespace

std::vector<PunctualLight> read_lights(const JsonCursor& root, std::vector<std::string>* notes) {
  std::vector<PunctualLight> lights;
  const auto extension = extension_of(root);
  if (!extension) return lights;
  const LightReader reader(notes);
  const JsonCursor list = extension->get("lights");
  for (const JsonCursor& at : list.items()) lights.push_back(reader.read(at));
  if (lights.empty()) reader.note(list, "is empty");
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
