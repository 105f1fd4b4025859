// The bytes that a glTF file consists of: its buffers and pictures, from data URIs, files in the
// scene's folder, or the GLB's chunk. tinygltf opens no file: it reads "+" in a name as a space,
// and refuses a buffer whose file is longer than declared.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/check/limits.h"
#include "scene/gltf/container.h"
#include "scene/gltf/model.h"
#include "scene/gltf/scene_folder.h"

namespace amalgam::scene {

class GltfResources {
 public:
  // The document has passed check_gltf(). All are referred to, not copied.
  GltfResources(const JsonCursor& root, const GltfContainer& container, const SceneFolder& folder,
                std::vector<std::string>& notes)
      : root_(root), container_(container), folder_(folder), notes_(notes) {}

  // Fills the model's buffers, each with byteLength bytes; one without data stays empty. Throws
  // SceneError naming the buffer.
  void read_buffers(tinygltf::Model& model) const;

  // Fills the model's images and the sources of its textures, after the buffers. Notes what is
  // wrong with a picture that no texture uses. Throws SceneError naming the image, also if all
  // together have more than max_bytes.
  void read_pictures(tinygltf::Model& model, std::size_t max_bytes = kMaxPictureBytes) const;

 private:
  using Bytes = std::vector<unsigned char>;
  // wanted: bytes from the front of a file. A data URI is decoded whole.
  Bytes read_uri(const JsonCursor& uri, std::size_t wanted) const;
  Bytes read_picture(const JsonCursor& image, const tinygltf::Model& model, std::size_t room) const;
  std::filesystem::path resolve(const JsonCursor& uri) const;

  const JsonCursor& root_;
  const GltfContainer& container_;
  const SceneFolder& folder_;
  std::vector<std::string>& notes_;
};

}  // namespace amalgam::scene
