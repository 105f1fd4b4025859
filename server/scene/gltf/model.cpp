#include "scene/gltf/model.h"

#include <algorithm>
#include <exception>
#include <limits>

#include "codec/picture.h"
#include "scene/gltf/check/check.h"
#include "scene/gltf/check/uri.h"
#include "scene/gltf/container.h"
#include "scene/gltf/lights.h"
#include "scene/gltf/scene_folder.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;

// tinygltf's file callbacks, jailed: what lies outside the scene's folder does not exist. tinygltf
// hands over folder + '/' + name with the base folder "" of ours, or looks in the process's own
// folder (".").
bool file_exists(const std::string& name, void* folder) {
  try {
    static_cast<const SceneFolder*>(folder)->resolve(name);
    return true;
  } catch (const SceneError&) {
    return false;
  }
}

std::string expand_path(const std::string& name, void*) {
  return name;
}

bool read_whole_file(std::vector<unsigned char>* out, std::string* error, const std::string& name,
                     void* folder) {
  try {
    const auto bytes = static_cast<const SceneFolder*>(folder)->read(name, kMaxFileBytes);
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    out->assign(data, data + bytes.size());
    return true;
  } catch (const SceneError& caught) {
    if (error) *error = caught.what();
    return false;
  }
}

// Keeps the encoded bytes: only textures that are used will be decoded.
bool keep_encoded(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
  image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

void check_lights(const JsonCursor& root) {
  const std::size_t lights = read_lights(root).size();
  const auto nodes = root.find("nodes");
  if (!nodes) return;
  for (const JsonCursor& node : nodes->items()) node_light(node, lights);
}

// tinygltf only warns when a picture is missing.
void check_external_files(const JsonCursor& root, const SceneFolder& folder) {
  for (const char* collection : {"buffers", "images"}) {
    const auto elements = root.find(collection);
    if (!elements) continue;
    for (const JsonCursor& element : elements->items()) {
      const auto uri = element.find("uri");
      if (!uri || is_data_uri(uri->string())) continue;
      try {
        folder.resolve(decode_percent(*uri));
      } catch (const SceneError& caught) {
        uri->fail(caught.what());
      }
    }
  }
}

std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void parse(tinygltf::Model& model, const GltfContainer& container, const SceneFolder& folder) {
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(keep_encoded, nullptr);
  loader.SetFsCallbacks(
      {file_exists, expand_path, read_whole_file, nullptr, const_cast<SceneFolder*>(&folder)});
  std::string error, warning;
  bool ok = false;
  try {
    if (container.is_glb) {
      ok = loader.LoadBinaryFromMemory(
          &model, &error, &warning, reinterpret_cast<const unsigned char*>(container.bytes.data()),
          static_cast<unsigned int>(container.bytes.size()));
    } else {
      ok = loader.LoadASCIIFromString(&model, &error, &warning, container.json.data(),
                                      static_cast<unsigned int>(container.json.size()), "");
    }
  } catch (const std::exception& caught) {  // bad_alloc, JSON type errors
    error = caught.what();
  }
  if (!ok) throw SceneError("tinygltf refuses it: " + one_line(error));
}

// A picture of a kind that we cannot read matters only to a material that uses it.
void check_pictures(const tinygltf::Model& model, std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < model.images.size(); ++i) {
    const auto encoded = std::as_bytes(std::span(model.images[i].image));
    if (!codec::is_picture(encoded)) {
      notes.push_back("images[" + std::to_string(i) + "]: neither PNG nor JPEG");
      continue;
    }
    try {
      codec::check_picture(encoded);
    } catch (const codec::PictureError& caught) {
      throw SceneError("images[" + std::to_string(i) + "]: " + caught.what());
    }
  }
}

}  // namespace

GltfModel load_gltf_model(const std::filesystem::path& path, std::vector<std::string>& notes) {
  const SceneFolder folder(path);
  const std::vector<std::byte> file = read_file(path, kMaxFileBytes);
  const GltfContainer container = open_gltf_container(file, path.extension() == ".glb");

  GltfModel loaded;
  loaded.document = parse_json(container.json);
  const JsonCursor root(loaded.document);
  std::optional<std::size_t> binary_bytes;
  if (container.binary) binary_bytes = container.binary->size();
  check_gltf(root, binary_bytes, notes);
  check_lights(root);
  check_external_files(root, folder);
  parse(loaded.model, container, folder);
  check_pictures(loaded.model, notes);
  return loaded;
}

}  // namespace amalgam::scene
