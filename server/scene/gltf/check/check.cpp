#include "scene/gltf/check/check.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "scene/gltf/check/check_context.h"
#include "scene/gltf/check/limits.h"

namespace amalgam::scene {
namespace {

constexpr std::array<std::string_view, 13> kCollections{
    "accessors", "animations", "buffers",  "bufferViews", "cameras", "images",  "materials",
    "meshes",    "nodes",      "samplers", "scenes",      "skins",   "textures"};

struct Version {
  int major = 0;
  int minor = 0;
  auto operator<=>(const Version&) const = default;
};

Version read_version(const JsonCursor& at) {
  const std::string& text = at.string();
  Version version;
  const char* const end = text.data() + text.size();
  const auto major = std::from_chars(text.data(), end, version.major);
  if (major.ec == std::errc() && major.ptr != end && *major.ptr == '.') {
    const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
    if (minor.ec == std::errc() && minor.ptr == end) return version;
  }
  at.fail("'" + text + "' is not a version such as 2.0");
}

}  // namespace

GltfCheckContext::GltfCheckContext(const JsonCursor& document,
                                   std::vector<std::string>& found_notes)
    : root(document), notes_(found_notes) {
  root.expect_object();
  for (const std::string_view name : kCollections) {
    auto& elements = collections_[std::string(name)];
    if (const auto found = root.find(name)) elements = listed(*found);
    if (elements.size() > kMaxElements) root.get(name).fail("has more than 200,000 elements");
    for (const JsonCursor& element : elements) element.expect_object();
  }
  if (const auto used = root.find("extensionsUsed")) {
    for (const JsonCursor& name : listed(*used)) {
      if (!used_.insert(name.string()).second) note(name, "'" + name.string() + "' occurs twice");
    }
  }
}

std::vector<JsonCursor> GltfCheckContext::listed(const JsonCursor& list) const {
  auto items = list.items();
  if (items.empty()) note(list, "is empty");
  return items;
}

bool GltfCheckContext::uses(std::string_view extension) const {
  return used_.contains(extension);
}

const std::vector<JsonCursor>& GltfCheckContext::all(std::string_view collection) const {
  return collections_.find(collection)->second;
}

std::size_t GltfCheckContext::resolve(const JsonCursor& reference,
                                      std::string_view collection) const {
  const auto index = static_cast<std::size_t>(reference.integer(0));
  const std::size_t count = all(collection).size();
  if (index >= count) {
    reference.fail("there is no " + std::string(collection) + "[" + std::to_string(index) +
                   "] (the file has " + std::to_string(count) + ")");
  }
  return index;
}

void GltfCheckContext::note(const JsonCursor& where, const std::string& what) const {
  add_note(where.path() + ": " + what);
}

void GltfCheckContext::add_note(std::string text) const {
  if (notes_.size() < kMaxNotes) notes_.push_back(std::move(text));
}

void check_asset(const GltfCheckContext& context) {
  const JsonCursor asset = context.root.get("asset");
  const JsonCursor at = asset.get("version");
  const Version version = read_version(at);
  if (version.major != 2) at.fail("glTF version " + at.string() + " is not supported, only 2.x");
  if (const auto minimum = asset.find("minVersion")) {
    if (read_version(*minimum) > Version{2, 0})
      minimum->fail("only readers of 2.0 are provided for");
    if (read_version(*minimum) > version) context.note(*minimum, "is above the file's own version");
  }
}

void check_gltf(const JsonCursor& root, std::optional<std::size_t> binary_bytes,
                std::vector<std::string>& notes) {
  GltfCheckContext context(root, notes);
  check_asset(context);
  check_extensions(context);
  check_buffers(context, binary_bytes);
  check_buffer_views(context);
  check_accessors(context);
  check_textures(context);
  check_materials(context);
  check_meshes(context);
  check_nodes(context);
  context.note_if_wrong("cameras are not used", [&] { check_cameras(context); });
  context.note_if_wrong("skins are not used", [&] { check_skins(context); });
  context.note_if_wrong("animations are not played", [&] { check_animations(context); });
}

}  // namespace amalgam::scene
