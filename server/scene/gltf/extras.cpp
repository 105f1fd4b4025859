#include "scene/gltf/extras.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace amalgam::scene {
namespace {

constexpr int kMaxMarker = 1'000'000;

std::optional<JsonCursor> object_member(const JsonCursor& holder, const char* name) {
  const auto found = holder.find(name);
  if (!found || found->value().kind != JsonValue::Kind::Object) return std::nullopt;
  return found;
}

// Our own block must be an object if it is there at all.
std::optional<JsonCursor> own_block(const std::optional<JsonCursor>& extras) {
  const auto found = extras ? extras->find("amalgam") : std::nullopt;
  if (found) found->expect_object();
  return found;
}

Role parse_role(const JsonCursor& at) {
  if (at.string() == "real") return Role::Real;
  if (at.string() == "virtual") return Role::Virtual;
  at.fail("'" + at.string() + "' is neither real nor virtual");
}

bool is_true(const JsonCursor& at) {
  const JsonValue& value = at.value();
  return (value.kind == JsonValue::Kind::Boolean && value.boolean) ||
         (value.kind == JsonValue::Kind::Number && value.number != 0.0);  // older Blender exports 1
}

}  // namespace

NodeExtras read_node_extras(const JsonCursor& node) {
  NodeExtras read;
  const auto extras = object_member(node, "extras");
  const auto catcher = extras ? extras->find("is_shadow_catcher") : std::nullopt;
  if (catcher && is_true(*catcher)) read.role = Role::Real;
  const auto own = own_block(extras);
  if (!own) return read;
  for (const auto& [name, at] : own->members()) {
    if (name == "role") {
      read.role = parse_role(at);
    } else if (name == "marker") {
      read.marker = static_cast<int>(at.integer(0, kMaxMarker));
    } else {
      at.fail("is unknown; a node has role and marker");
    }
  }
  return read;
}

SceneExtras read_scene_extras(const JsonCursor& scene) {
  SceneExtras read;
  const auto own = own_block(object_member(scene, "extras"));
  if (!own) return read;
  for (const auto& [name, at] : own->members()) {
    if (name == "world_marker") {
      read.world.marker = static_cast<int>(at.integer(0, kMaxMarker));
      read.has_world_marker = true;
    } else if (name == "dictionary") {
      read.world.dictionary = at.string();
    } else if (name == "marker_length") {
      read.world.marker_length = at.number(1e-4, 100.0);
    } else if (name == "environment") {
      read.environment = at.string();
    } else {
      at.fail("is unknown; a scene has world_marker, dictionary, marker_length and environment");
    }
  }
  return read;
}

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool looks_like_ours(const std::string& name) {
  constexpr std::array<std::string_view, 6> kMembers{"role",       "marker",        "world_marker",
                                                     "dictionary", "marker_length", "environment"};
  const std::string small = lower(name);
  return name != "amalgam" &&
         (small.starts_with("amalgam") ||
          std::find(kMembers.begin(), kMembers.end(), small) != kMembers.end());
}

}  // namespace

std::vector<std::string> doubtful_extras(const JsonCursor& root) {
  std::vector<std::string> doubts;
  bool any = false;
  for (const char* collection : {"scenes", "nodes", "meshes", "materials"}) {
    const auto elements = root.find(collection);
    if (!elements) continue;
    const std::string_view kind = collection;
    const bool may_have_ours = kind == "scenes" || kind == "nodes";
    for (const JsonCursor& element : elements->items()) {
      const auto extras = object_member(element, "extras");
      if (!extras) continue;
      for (const auto& [name, at] : extras->members()) {
        const bool is_ours = name == "amalgam" || name == "is_shadow_catcher";
        if (is_ours && may_have_ours) any = true;
        if (looks_like_ours(name)) {
          doubts.push_back(at.path() +
                           ": is not read; \"extras\": {\"amalgam\": {...}} holds what is ours");
        } else if (is_ours && !may_have_ours) {
          doubts.push_back(at.path() + ": is not read here, only at nodes and scenes");
        }
      }
    }
  }
  if (!any) {
    doubts.emplace_back(
        "no \"extras\": {\"amalgam\": ...} in the file: all of it is virtual, on marker 0 of "
        "DICT_6X6_250 with 0.05 m");
  }
  return doubts;
}

}  // namespace amalgam::scene
