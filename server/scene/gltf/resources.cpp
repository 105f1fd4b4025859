#include "scene/gltf/resources.h"

#include <algorithm>
#include <span>

#include "codec/picture.h"
#include "scene/gltf/check/limits.h"
#include "scene/gltf/check/texture_source.h"
#include "scene/gltf/check/uri.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

std::vector<unsigned char> bytes_of(std::span<const std::byte> bytes) {
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  return {data, data + bytes.size()};
}

// Not only noted where no texture uses the picture: the next one would be read in vain too.
class NoRoom : public SceneError {
 public:
  using SceneError::SceneError;
};

std::vector<JsonCursor> elements(const JsonCursor& root, const char* collection) {
  const auto found = root.find(collection);
  return found ? found->items() : std::vector<JsonCursor>{};
}

}  // namespace

// With its %XX undone or, if there is no such file, as writers leave names that ought to be
// escaped.
std::filesystem::path GltfResources::resolve(const JsonCursor& uri) const {
  std::string refusal;
  try {
    return folder_.resolve(decode_percent(uri));
  } catch (const SceneError& caught) {
    refusal = caught.what();
  }
  std::string with_slashes = decode_percent(uri);
  std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
  for (const std::string& name : {uri.string(), with_slashes}) {
    try {
      const auto path = folder_.resolve(name);
      notes_.push_back(uri.path() + ": is not escaped as a URI");
      return path;
    } catch (const SceneError&) {
      continue;
    }
  }
  uri.fail(refusal);
}

std::vector<unsigned char> GltfResources::read_uri(const JsonCursor& uri,
                                                   std::size_t wanted) const {
  if (is_data_uri(uri.string())) return decode_data_uri(uri);
  return bytes_of(read_file(resolve(uri), kMaxFileBytes, wanted));
}

void GltfResources::read_buffers(tinygltf::Model& model) const {
  for (const JsonCursor& at : elements(root_, "buffers")) {
    const auto length = static_cast<std::size_t>(at.get("byteLength").integer(0));
    const auto uri = at.find("uri");
    Bytes& data = model.buffers.emplace_back().data;
    if (uri) {
      data = read_uri(*uri, length);
    } else if (model.buffers.size() == 1 && container_.binary) {
      data = bytes_of(container_.binary->first(std::min(length, container_.binary->size())));
    } else {
      continue;  // the check lets only buffers pass that nothing reads
    }
    if (data.size() < length) {
      at.fail("byteLength is " + std::to_string(length) + ", but there are " +
              std::to_string(data.size()) + " bytes");
    }
    data.resize(length);
  }
}

std::vector<unsigned char> GltfResources::read_picture(const JsonCursor& at,
                                                       const tinygltf::Model& model,
                                                       std::size_t room) const {
  const auto check_room = [&](std::size_t bytes) {
    if (bytes > room) throw NoRoom(at.path() + ": the pictures together are too large");
  };
  Bytes encoded;
  if (const auto uri = at.find("uri")) {
    // One byte more than there is room for tells that it is too large.
    encoded = read_uri(*uri, room + 1);
    check_room(encoded.size());
  } else if (const auto view_at = at.find("bufferView")) {
    const auto& view = model.bufferViews[static_cast<std::size_t>(view_at->integer(0))];
    const Bytes& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (data.size() < view.byteOffset + view.byteLength) at.fail("its buffer has no data");
    check_room(view.byteLength);
    const auto first = data.begin() + static_cast<std::ptrdiff_t>(view.byteOffset);
    encoded.assign(first, first + static_cast<std::ptrdiff_t>(view.byteLength));
  } else {
    return encoded;
  }
  if (encoded.empty()) at.fail("the file is empty");
  // One of a kind that we cannot read matters only to a material that uses it.
  const auto bytes = std::as_bytes(std::span(encoded));
  if (!codec::is_picture(bytes)) {
    notes_.push_back(at.path() + ": is neither PNG nor JPEG nor WebP");
    return encoded;
  }
  try {
    codec::check_picture(bytes);
  } catch (const codec::PictureError& caught) {
    at.fail(caught.what());
  }
  return encoded;
}

void GltfResources::read_pictures(tinygltf::Model& model, std::size_t max_bytes) const {
  const auto images = elements(root_, "images");
  const auto textures = elements(root_, "textures");
  std::vector<bool> is_used(images.size(), false);
  for (std::size_t i = 0; i < textures.size(); ++i) {
    const auto source = texture_source(textures[i]);
    model.textures[i].source = source ? static_cast<int>(*source) : -1;
    if (source) is_used[*source] = true;
  }
  model.images.resize(images.size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    try {
      model.images[i].image = read_picture(images[i], model, max_bytes);
      max_bytes -= model.images[i].image.size();
    } catch (const NoRoom&) {
      throw;
    } catch (const SceneError& caught) {
      if (is_used[i]) throw;
      notes_.push_back(std::string(caught.what()) + " (no texture uses it)");
    }
  }
  for (tinygltf::Texture& texture : model.textures) {
    if (texture.source < 0) continue;
    if (model.images[static_cast<std::size_t>(texture.source)].image.empty()) texture.source = -1;
  }
}

}  // namespace amalgam::scene
