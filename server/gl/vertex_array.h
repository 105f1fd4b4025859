// Owns one indexed triangle mesh in GPU memory: its vertices, indices and their layout.
#pragma once

#include <epoxy/gl.h>

#include <optional>

#include "gl/buffer.h"
#include "scene/scene.h"

namespace amalgam::gl {

class VertexArray {
 public:
  // Attributes as in shader_interface.h; uvs are zero if the mesh has none. Colors, tangents and
  // second uvs have a buffer of their own, if the mesh has any of them.
  explicit VertexArray(const scene::Mesh& mesh);
  ~VertexArray();
  VertexArray(VertexArray&& other) noexcept;
  VertexArray& operator=(VertexArray&& other) noexcept;
  VertexArray(const VertexArray&) = delete;
  VertexArray& operator=(const VertexArray&) = delete;

  void draw() const;

 private:
  Buffer vertices_;
  std::optional<Buffer> details_;
  Buffer indices_;
  GLsizei index_count_ = 0;
  GLuint id_ = 0;
};

}  // namespace amalgam::gl
