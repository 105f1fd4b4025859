#include "scene/gltf/reduced_document.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace amalgam::scene {
namespace {

using nlohmann::json;

// Nesting is bounded by parse_json(), which has read the same text.
void simplify(json& value) {
  if (value.is_number_float()) {
    const double number = value.get<double>();
    constexpr double kExact = 9007199254740992.0;  // 2^53
    if (number == std::floor(number) && std::abs(number) <= kExact) {
      value = static_cast<std::int64_t>(number);
    }
  }
  if (value.is_array()) {
    for (json& item : value) simplify(item);
  }
  if (!value.is_object()) return;
  for (auto it = value.begin(); it != value.end();) {
    simplify(*it);
    it = it->is_array() && it->empty() ? value.erase(it) : std::next(it);
  }
}

void erase(json& holder, std::initializer_list<const char*> names) {
  for (const char* name : names) holder.erase(name);
}

bool are_numbers(const json& list) {
  return list.is_array() &&
         std::all_of(list.begin(), list.end(), [](const json& item) { return item.is_number(); });
}

void reduce_accessor(json& accessor) {
  for (const char* bound : {"min", "max"}) {
    if (accessor.contains(bound) && !are_numbers(accessor[bound])) accessor.erase(bound);
  }
  const auto sparse = accessor.find("sparse");
  if (sparse != accessor.end() && sparse->value("count", 0) == 0) accessor.erase("sparse");
}

// tinygltf leaves out a primitive silently if one of its attributes is no integer.
void reduce_primitive(json& primitive) {
  erase(primitive, {"extensions", "indices", "targets"});
  json& attributes = primitive["attributes"];
  for (auto it = attributes.begin(); it != attributes.end();) {
    it = it->is_number_integer() ? std::next(it) : attributes.erase(it);
  }
}

}  // namespace

std::string reduced_document(std::string_view text) {
  json document = json::parse(text);
  simplify(document);
  erase(document, {"animations", "buffers", "cameras", "extensions", "extensionsRequired",
                   "extensionsUsed", "images", "skins"});
  const auto for_each = [&](const char* collection, auto reduce) {
    if (!document.contains(collection)) return;
    for (json& element : document[collection]) reduce(element);
  };
  for_each("accessors", reduce_accessor);
  for_each("bufferViews", [](json& view) { erase(view, {"byteStride", "extensions", "target"}); });
  for_each("nodes", [](json& node) { erase(node, {"camera", "extensions", "weights"}); });
  for_each("textures", [](json& texture) { erase(texture, {"extensions", "source"}); });
  for_each("meshes", [](json& mesh) {
    erase(mesh, {"weights"});
    if (!mesh.contains("primitives")) return;
    for (json& primitive : mesh["primitives"]) reduce_primitive(primitive);
  });
  return document.dump();
}

}  // namespace amalgam::scene
