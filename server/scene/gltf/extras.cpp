#include "scene/gltf/extras.h"

#include <string>

#include "scene/gltf/check/limits.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

std::optional<JsonCursor> object_member(const JsonCursor& holder, const char* name) {
  auto found = holder.find(name);
  if (!found || found->value().kind != JsonValue::Kind::Object) return std::nullopt;
  return found;
}

JsonValue parse_text(const JsonCursor& at) {
  try {
    return parse_json(at.string());
  } catch (const SceneError& caught) {
    at.fail("is a text that holds no JSON (" + std::string(caught.what()) +
            "); JSON has double quotes, as in {\"role\": \"real\"}");
  }
}

// Calls read(name, value) for each member of our own block, which must be an object if it is there.
template <typename Read>
void read_own_members(const std::optional<JsonCursor>& extras, const Read& read) {
  const auto own = extras ? extras->find("amalgam") : std::nullopt;
  if (!own) return;
  const bool is_text = own->value().kind == JsonValue::Kind::String;
  const JsonValue parsed = is_text ? parse_text(*own) : JsonValue{};
  const JsonCursor block = is_text ? JsonCursor(parsed, own->path()) : *own;
  for (const auto& [name, at] : block.members()) read(name, at);
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
  read_own_members(extras, [&](const std::string& name, const JsonCursor& at) {
    if (name == "role") {
      read.role = parse_role(at);
    } else if (name == "marker") {
      read.marker = static_cast<int>(at.integer(0, kMaxMarker));
    } else {
      at.fail("is unknown; a node has role and marker");
    }
  });
  return read;
}

SceneExtras read_scene_extras(const JsonCursor& scene) {
  SceneExtras read;
  read_own_members(object_member(scene, "extras"), [&](const std::string& name,
                                                       const JsonCursor& at) {
    if (name == "world_marker") {
      read.world.marker = static_cast<int>(at.integer(0, kMaxMarker));
    } else if (name == "dictionary") {
      read.world.dictionary = at.string();
    } else if (name == "marker_length") {
      read.world.marker_length = at.number(1e-4, 100.0);
    } else if (name == "environment") {
      read.environment = at.string();
    } else {
      at.fail("is unknown; a scene has world_marker, dictionary, marker_length and environment");
    }
  });
  return read;
}

}  // namespace amalgam::scene
