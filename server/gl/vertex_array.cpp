#include "gl/vertex_array.h"

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

namespace amalgam::gl {
namespace {

struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec2 uv;
};

std::vector<Vertex> interleave(const scene::Mesh& mesh) {
  std::vector<Vertex> vertices(mesh.positions.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    vertices[i] = {mesh.positions[i], mesh.normals[i],
                   mesh.uvs.empty() ? glm::vec2(0.0f) : mesh.uvs[i]};
  }
  return vertices;
}

}  // namespace

VertexArray::VertexArray(const scene::Mesh& mesh)
    : vertices_(Buffer::of(std::span<const Vertex>(interleave(mesh)))),
      indices_(Buffer::of(std::span(mesh.triangles))),
      index_count_(static_cast<GLsizei>(mesh.triangles.size() * 3)) {
  glCreateVertexArrays(1, &id_);
  glVertexArrayVertexBuffer(id_, 0, vertices_.id(), 0, sizeof(Vertex));
  glVertexArrayElementBuffer(id_, indices_.id());
  const auto attribute = [&](GLuint index, GLint components, std::size_t offset) {
    glEnableVertexArrayAttrib(id_, index);
    glVertexArrayAttribFormat(id_, index, components, GL_FLOAT, GL_FALSE,
                              static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(id_, index, 0);
  };
  attribute(0, 3, offsetof(Vertex, position));
  attribute(1, 3, offsetof(Vertex, normal));
  attribute(2, 2, offsetof(Vertex, uv));
}

VertexArray::~VertexArray() {
  if (id_ != 0) glDeleteVertexArrays(1, &id_);
}

VertexArray::VertexArray(VertexArray&& other) noexcept
    : vertices_(std::move(other.vertices_)),
      indices_(std::move(other.indices_)),
      index_count_(other.index_count_),
      id_(std::exchange(other.id_, 0)) {}

VertexArray& VertexArray::operator=(VertexArray&& other) noexcept {
  std::swap(vertices_, other.vertices_);
  std::swap(indices_, other.indices_);
  std::swap(index_count_, other.index_count_);
  std::swap(id_, other.id_);
  return *this;
}

void VertexArray::draw() const {
  glBindVertexArray(id_);
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace amalgam::gl
