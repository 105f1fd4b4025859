#include "scene/gltf/model.h"

#include <exception>

#include "common/one_line.h"
#include "scene/gltf/check/check.h"
#include "scene/gltf/check/limits.h"
#include "scene/gltf/compressed_data.h"
#include "scene/gltf/container.h"
#include "scene/gltf/lights.h"
#include "scene/gltf/reduced_document.h"
#include "scene/gltf/resources.h"
#include "scene/gltf/scene_folder.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

void check_lights(const JsonCursor& root, std::vector<std::string>& notes) {
  const std::size_t lights = read_lights(root, &notes).size();
  const auto nodes = root.find("nodes");
  if (!nodes) return;
  for (const JsonCursor& node : nodes->items()) node_light(node, lights);
}

void parse(tinygltf::Model& model, const std::string& json) {
  tinygltf::TinyGLTF loader;
  std::string error, warning;
  bool ok = false;
  try {
    ok = loader.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                    static_cast<unsigned int>(json.size()), "");
  } catch (const std::exception& caught) {  // bad_alloc, JSON type errors
    error = caught.what();
  }
  if (!ok) throw SceneError("tinygltf refuses it: " + common::one_line(error));
}

// What reduced_document() leaves out and later steps read.
void set_strides(const JsonCursor& root, tinygltf::Model& model) {
  if (model.bufferViews.empty()) return;
  const auto views = root.get("bufferViews").items();
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto stride = views[i].find("byteStride");
    if (stride) model.bufferViews[i].byteStride = static_cast<std::size_t>(stride->integer(0));
  }
}

void set_indices(const JsonCursor& root, tinygltf::Model& model) {
  if (model.meshes.empty()) return;
  const auto meshes = root.get("meshes").items();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto primitives = meshes[i].get("primitives").items();
    if (primitives.size() != model.meshes[i].primitives.size()) {
      meshes[i].fail("has a primitive that tinygltf does not take");
    }
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      const auto indices = primitives[k].find("indices");
      if (indices) model.meshes[i].primitives[k].indices = static_cast<int>(indices->integer(0));
    }
  }
}

std::string_view without_byte_order_mark(std::string_view json, std::vector<std::string>& notes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (!json.starts_with(kMark)) return json;
  notes.emplace_back("begins with a byte order mark");
  return json.substr(kMark.size());
}

}  // namespace

GltfModel load_gltf_model(const std::filesystem::path& path, std::vector<std::string>& notes) {
  const SceneFolder folder(path);
  const std::vector<std::byte> file = read_file(path, kMaxFileBytes);
  const GltfContainer container = open_gltf_container(file, path.extension() == ".glb", notes);
  const std::string_view json = without_byte_order_mark(container.json, notes);

  GltfModel loaded;
  loaded.document = parse_json(json);
  const JsonCursor root(loaded.document);
  std::optional<std::size_t> binary_bytes;
  if (container.binary) binary_bytes = container.binary->size();
  check_gltf(root, binary_bytes, notes);
  check_lights(root, notes);
  parse(loaded.model, reduced_document(json));
  set_strides(root, loaded.model);
  set_indices(root, loaded.model);
  const GltfResources resources(root, container, folder, notes);
  resources.read_buffers(loaded.model);
  decompress_meshopt(root, loaded.model);
  resources.read_pictures(loaded.model);
  decompress_draco(root, loaded.model);
  return loaded;
}

}  // namespace amalgam::scene
