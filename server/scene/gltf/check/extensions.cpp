#include <algorithm>
#include <array>

#include "scene/gltf/check/check_context.h"

namespace amalgam::scene {
namespace {

// Extensions whose meaning is honoured.
constexpr std::array<std::string_view, 10> kHonoured{
    "EXT_meshopt_compression",         "EXT_texture_webp",
    "KHR_draco_mesh_compression",      "KHR_lights_punctual",
    "KHR_materials_emissive_strength", "KHR_materials_ior",
    "KHR_materials_transmission",      "KHR_materials_volume",
    "KHR_mesh_quantization",           "KHR_texture_transform"};

// Without these a file is readable as it is. KHR_texture_basisu is refused where a texture has no
// other picture (texture_source.h).
constexpr std::array<std::string_view, 11> kIgnored{
    "KHR_materials_anisotropy",  "KHR_materials_clearcoat", "KHR_materials_dispersion",
    "KHR_materials_iridescence", "KHR_materials_sheen",     "KHR_materials_specular",
    "KHR_materials_unlit",       "KHR_materials_variants",  "KHR_node_visibility",
    "KHR_texture_basisu",        "KHR_xmp_json_ld"};

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void check_extensions(const GltfCheckContext& context) {
  const auto list = [&](std::string_view name) {
    const auto found = context.root.find(name);
    return found ? found->items() : std::vector<JsonCursor>{};
  };
  if (const auto required = context.root.find("extensionsRequired")) {
    for (const JsonCursor& at : context.listed(*required)) {
      const std::string& name = at.string();
      if (!is_among(kHonoured, name) && !is_among(kIgnored, name)) {
        required->fail("the file cannot be read without the extension " + name +
                       ", which is not supported");
      }
      if (!context.uses(name)) context.note(at, name + " is missing from extensionsUsed");
    }
  }
  for (const JsonCursor& at : list("extensionsUsed")) {
    if (!is_among(kHonoured, at.string())) {
      context.note(at, at.string() + " is not supported, ignored");
    }
  }
  // Extension objects must be objects; KHR_lights_punctual's own content is read by the loader.
  const auto check_object = [&](const JsonCursor& holder) {
    const auto extensions = holder.find("extensions");
    if (!extensions) return;
    for (const auto& [name, extension] : extensions->members()) {
      extension.expect_object();
      if (!context.uses(name)) context.note(extension, "is not declared in extensionsUsed");
    }
  };
  check_object(context.root);
  for (const char* collection : {"accessors", "buffers", "bufferViews", "images", "materials",
                                 "meshes", "nodes", "samplers", "scenes", "textures"}) {
    for (const JsonCursor& element : context.all(collection)) check_object(element);
  }
}

}  // namespace amalgam::scene
