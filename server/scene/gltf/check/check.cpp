#include "scene/gltf/check/check.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "scene/gltf/check/check_context.h"

namespace amalgam::scene {
namespace {

constexpr std::array<std::string_view, 13> kCollections{
    "accessors", "animations", "buffers",  "bufferViews", "cameras", "images",  "materials",
    "meshes",    "nodes",      "samplers", "scenes",      "skins",   "textures"};

// Extensions whose meaning is honoured or whose absence leaves a file readable as it is.
constexpr std::array<std::string_view, 13> kKnownExtensions{
    "KHR_lights_punctual",    "KHR_materials_clearcoat",    "KHR_materials_emissive_strength",
    "KHR_materials_ior",      "KHR_materials_iridescence",  "KHR_materials_sheen",
    "KHR_materials_specular", "KHR_materials_transmission", "KHR_materials_unlit",
    "KHR_materials_variants", "KHR_materials_volume",       "KHR_texture_transform",
    "KHR_xmp_json_ld"};

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
  constexpr std::size_t kMaxElements = 200'000;
  root.expect_object();
  for (const std::string_view name : kCollections) {
    auto& elements = collections_[std::string(name)];
    if (const auto found = root.find(name)) elements = found->filled_items();
    if (elements.size() > kMaxElements) root.get(name).fail("has more than 200,000 elements");
    for (const JsonCursor& element : elements) element.expect_object();
  }
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
  constexpr std::size_t kMaxNotes = 1000;  // a huge file may repeat one slip everywhere
  if (notes_.size() < kMaxNotes) notes_.push_back(where.path() + ": " + what);
}

void check_asset(const GltfCheckContext& context) {
  const JsonCursor asset = context.root.get("asset");
  const JsonCursor at = asset.get("version");
  const Version version = read_version(at);
  if (version.major != 2) at.fail("glTF version " + at.string() + " is not supported, only 2.x");
  if (const auto minimum = asset.find("minVersion")) {
    if (read_version(*minimum) > version) minimum->fail("is above the file's own version");
    if (read_version(*minimum) > Version{2, 0})
      minimum->fail("only readers of 2.0 are provided for");
  }
}

void check_extensions(const GltfCheckContext& context) {
  const auto names = [&](std::string_view list) {
    std::set<std::string> all;
    const auto found = context.root.find(list);
    if (!found) return all;
    for (const JsonCursor& name : found->filled_items()) {
      if (!all.insert(name.string()).second) name.fail("'" + name.string() + "' occurs twice");
    }
    return all;
  };
  const auto used = names("extensionsUsed");
  for (const std::string& required : names("extensionsRequired")) {
    const JsonCursor at = context.root.get("extensionsRequired");
    if (std::find(kKnownExtensions.begin(), kKnownExtensions.end(), required) ==
        kKnownExtensions.end()) {
      at.fail("the file cannot be read without the extension " + required +
              ", which is not supported");
    }
    if (!used.contains(required)) at.fail(required + " is missing from extensionsUsed");
  }
  // Extension objects must be objects; KHR_lights_punctual's own content is read by the loader.
  const auto check_object = [&](const JsonCursor& holder) {
    const auto extensions = holder.find("extensions");
    if (!extensions) return;
    for (const auto& [name, extension] : extensions->members()) {
      extension.expect_object();
      if (!used.contains(name)) context.note(extension, "is not declared in extensionsUsed");
    }
  };
  check_object(context.root);
  for (const std::string_view collection : kCollections) {
    for (const JsonCursor& element : context.all(collection)) check_object(element);
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
  check_cameras(context);
  check_meshes(context);
  check_nodes(context);
  check_skins(context);
  check_animations(context);
}

}  // namespace amalgam::scene
