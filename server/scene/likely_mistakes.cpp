#include "scene/likely_mistakes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>
#include <string_view>

#include "scene/bounds.h"
#include "scene/closed_mesh.h"
#include "scene/marker_ids.h"

namespace amalgam::scene {
namespace {

// Markers of the dictionaries whose names do not end with their number.
constexpr std::array<std::pair<std::string_view, int>, 5> kOtherSizes{{
    {"DICT_ARUCO_ORIGINAL", 1024},
    {"DICT_APRILTAG_16h5", 30},
    {"DICT_APRILTAG_25h9", 35},
    {"DICT_APRILTAG_36h10", 2320},
    {"DICT_APRILTAG_36h11", 587},
}};

// Nothing for a name that is none of OpenCV's.
std::optional<int> dictionary_size(std::string_view name) {
  for (const auto& [known, size] : kOtherSizes) {
    if (name == known) return size;
  }
  for (const std::string_view begin : {"DICT_4X4_", "DICT_5X5_", "DICT_6X6_", "DICT_7X7_"}) {
    if (!name.starts_with(begin)) continue;
    const std::string_view number = name.substr(begin.size());
    for (const int size : {50, 100, 250, 1000}) {
      if (number == std::to_string(size)) return size;
    }
  }
  return std::nullopt;
}

void check_markers(const Scene& scene, std::vector<std::string>& mistakes) {
  const std::string& name = scene.world.dictionary;
  const bool is_file = name.ends_with(".yml") || name.ends_with(".yaml");
  const auto size = dictionary_size(name);
  if (!size && !is_file) {
    const std::string with_prefix = "DICT_" + name;
    mistakes.push_back("the dictionary '" + name + "' is none of OpenCV's" +
                       (dictionary_size(with_prefix) ? "; " + with_prefix + " is" : ""));
  }
  for (const int id : marker_ids(scene)) {
    if (size && id >= *size) {
      mistakes.push_back(name + " has no marker " + std::to_string(id) + ", only 0 to " +
                         std::to_string(*size - 1));
    }
  }
  constexpr double kLargest = 2.0;  // metres
  if (scene.world.marker_length > kLargest) {
    mistakes.push_back("marker_length is in metres: one of " +
                       std::to_string(std::lround(scene.world.marker_length)) +
                       " m is larger than people print");
  }
}

// A pane has a body too, and is thin rightly.
bool is_flat(const Bounds& box) {
  const glm::vec3 size = box.high - box.low;
  constexpr float kPane = 0.1f;
  return glm::min(size.x, glm::min(size.y, size.z)) <=
         kPane * glm::max(size.x, glm::max(size.y, size.z));
}

void check_glass(const Scene& scene, std::vector<std::string>& mistakes) {
  std::map<std::uint32_t, bool> bodies;  // by mesh: many instances may share a large one
  for (const Instance& instance : scene.instances) {
    const Material& material = scene.materials[instance.material];
    if (material.kind != MaterialKind::Dielectric || !material.thin) continue;
    const auto [body, is_new] = bodies.try_emplace(instance.mesh);
    const Mesh& mesh = scene.meshes[instance.mesh];
    if (is_new) body->second = !is_flat(bounds_of(mesh)) && is_closed(mesh);
    if (!body->second) continue;
    mistakes.push_back("node " + instance.node + ": its material " + material.name +
                       " transmits light and has no thickness, so that its glass does not refract; "
                       "a KHR_materials_volume with a thickness above 0 makes it solid (README, "
                       "Scenes)");
  }
}

bool is_lit(const Scene& scene) {
  const bool has_light =
      std::any_of(scene.punctual_lights.begin(), scene.punctual_lights.end(),
                  [](const PunctualLight& light) { return light.intensity != glm::vec3(0.0f); });
  return has_light ||
         (scene.environment && largest_radiance(*scene.environment) != glm::vec3(0.0f));
}

}  // namespace

std::vector<std::string> likely_mistakes(const Scene& scene) {
  std::vector<std::string> mistakes;
  if (!is_lit(scene)) {
    mistakes.emplace_back(
        "no light and no environment: surfaces are black, unless a client sends an environment");
  }
  check_glass(scene, mistakes);
  check_markers(scene, mistakes);
  return mistakes;
}

std::vector<std::string> nodes_around(const Scene& scene, int marker, const glm::dvec3& point) {
  std::vector<std::string> nodes;
  for (const Instance& instance : scene.instances) {
    if (instance.marker.value_or(scene.world.marker) != marker) continue;
    const Mesh& mesh = scene.meshes[instance.mesh];
    const glm::dvec3 inside(glm::inverse(instance.anchor_from_mesh) * glm::dvec4(point, 1.0));
    const Bounds box = bounds_of(mesh);
    const bool in_box = glm::all(glm::greaterThan(inside, glm::dvec3(box.low))) &&
                        glm::all(glm::lessThan(inside, glm::dvec3(box.high)));
    constexpr double kHalf = 0.5;
    if (in_box && std::abs(winding_number(mesh, inside)) > kHalf && is_closed(mesh)) {
      nodes.push_back(instance.node);
    }
  }
  return nodes;
}

}  // namespace amalgam::scene
