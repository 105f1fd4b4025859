#include "gl/vertex_array.h"

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <utility>
#include <vector>

#include "gl/shader_interface.h"

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

struct VertexDetails {
  glm::vec4 color{1.0f};
  glm::vec4 tangent{0.0f};
  glm::vec2 second_uv{0.0f};
};

std::optional<Buffer> upload_details(const scene::Mesh& mesh) {
  if (mesh.colors.empty() && mesh.tangents.empty() && mesh.second_uvs.empty()) return std::nullopt;
  std::vector<VertexDetails> details(mesh.positions.size());
  for (std::size_t i = 0; i < details.size(); ++i) {
    if (!mesh.colors.empty()) details[i].color = mesh.colors[i];
    if (!mesh.tangents.empty()) details[i].tangent = mesh.tangents[i];
    if (!mesh.second_uvs.empty()) details[i].second_uv = mesh.second_uvs[i];
  }
  return Buffer::of(std::span<const VertexDetails>(details));
}

}  // namespace

VertexArray::VertexArray(const scene::Mesh& mesh)
    : vertices_(Buffer::of(std::span<const Vertex>(interleave(mesh)))),
      details_(upload_details(mesh)),
      indices_(Buffer::of(std::span(mesh.triangles))),
      index_count_(static_cast<GLsizei>(mesh.triangles.size() * 3)) {
  glCreateVertexArrays(1, &id_);
  glVertexArrayVertexBuffer(id_, 0, vertices_.id(), 0, sizeof(Vertex));
  glVertexArrayElementBuffer(id_, indices_.id());
  const auto attribute = [&](GLuint index, GLint components, GLuint binding, std::size_t offset) {
    glEnableVertexArrayAttrib(id_, index);
    glVertexArrayAttribFormat(id_, index, components, GL_FLOAT, GL_FALSE,
                              static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(id_, index, binding);
  };
  attribute(kPositionAttribute, 3, 0, offsetof(Vertex, position));
  attribute(kNormalAttribute, 3, 0, offsetof(Vertex, normal));
  attribute(kUvAttribute, 2, 0, offsetof(Vertex, uv));
  if (!details_) return;
  glVertexArrayVertexBuffer(id_, 1, details_->id(), 0, sizeof(VertexDetails));
  attribute(kColorAttribute, 4, 1, offsetof(VertexDetails, color));
  attribute(kTangentAttribute, 4, 1, offsetof(VertexDetails, tangent));
  attribute(kSecondUvAttribute, 2, 1, offsetof(VertexDetails, second_uv));
}

VertexArray::~VertexArray() {
  if (id_ != 0) glDeleteVertexArrays(1, &id_);
}

VertexArray::VertexArray(VertexArray&& other) noexcept
    : vertices_(std::move(other.vertices_)),
      details_(std::move(other.details_)),
      indices_(std::move(other.indices_)),
      index_count_(other.index_count_),
      id_(std::exchange(other.id_, 0)) {}

VertexArray& VertexArray::operator=(VertexArray&& other) noexcept {
  std::swap(vertices_, other.vertices_);
  std::swap(details_, other.details_);
  std::swap(indices_, other.indices_);
  std::swap(index_count_, other.index_count_);
  std::swap(id_, other.id_);
  return *this;
}

void VertexArray::draw() const {
  glBindVertexArray(id_);
  // The value of an attribute without an array: neutral to the color.
  if (!details_) glVertexAttrib4f(kColorAttribute, 1.0f, 1.0f, 1.0f, 1.0f);
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace amalgam::gl
