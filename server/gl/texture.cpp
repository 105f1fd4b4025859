#include "gl/texture.h"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/log.h"
#include "gl/gl_error.h"

namespace amalgam::gl {
namespace {

// Errors stay pending until they are asked for, so this tells of everything that was drawn before.
constexpr const char* kReading = "drawing or reading a texture";

struct FormatInfo {
  GLenum internal;
  GLenum external;
  GLenum type;
  std::size_t bytes;
};

FormatInfo describe(TextureFormat format) {
  switch (format) {
    case TextureFormat::R8ui:
      return {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1};
    case TextureFormat::Rgba8ui:
      return {GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, 4};
    case TextureFormat::Rgba32f:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
    case TextureFormat::Depth32f:
      return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4};
  }
  throw std::logic_error("unknown texture format");
}

void check_limits(glm::ivec2 size, int layers) {
  GLint max_side = 0, max_layers = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &max_side);
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &max_layers);
  if (size.x < 1 || size.y < 1 || size.x > max_side || size.y > max_side || layers > max_layers) {
    throw std::runtime_error(
        "a texture of " + std::to_string(size.x) + "x" + std::to_string(size.y) + " with " +
        std::to_string(layers) + " layers is not within this OpenGL's " + std::to_string(max_side) +
        "x" + std::to_string(max_side) + " and " + std::to_string(max_layers) + " layers");
  }
}

}  // namespace

std::size_t texel_bytes(TextureFormat format) {
  return describe(format).bytes;
}

Texture::Texture(TextureFormat format, glm::ivec2 size, int layers)
    : format_(format), size_(size), layers_(layers) {
  check_limits(size, layers);
  const GLenum internal = describe(format).internal;
  glCreateTextures(is_array() ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, &id_);
  if (is_array()) {
    glTextureStorage3D(id_, 1, internal, size.x, size.y, layers);
  } else {
    glTextureStorage2D(id_, 1, internal, size.x, size.y);
  }
  try {
    throw_pending_gl_error("texture of " + std::to_string(size.x) + "x" + std::to_string(size.y));
  } catch (...) {
    glDeleteTextures(1, &id_);
    throw;
  }
  // Shaders fetch single texels and filter them in float, alike on every driver.
  glTextureParameteri(id_, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(id_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

Texture::~Texture() {
  if (id_ != 0) glDeleteTextures(1, &id_);
}

Texture::Texture(Texture&& other) noexcept
    : id_(std::exchange(other.id_, 0)),
      format_(other.format_),
      size_(other.size_),
      layers_(other.layers_) {}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(format_, other.format_);
  std::swap(size_, other.size_);
  std::swap(layers_, other.layers_);
  return *this;
}

void Texture::upload(const void* texels) {
  AMALGAM_CHECK(!is_array(), "upload to an array texture");
  const FormatInfo info = describe(format_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id_, 0, 0, 0, size_.x, size_.y, info.external, info.type, texels);
  throw_pending_gl_error("uploading a texture");
}

void Texture::read(void* texels, std::size_t bytes) const {
  const FormatInfo info = describe(format_);
  const std::size_t expected = static_cast<std::size_t>(size_.x) *
                               static_cast<std::size_t>(size_.y) * info.bytes *
                               static_cast<std::size_t>(is_array() ? layers_ : 1);
  AMALGAM_CHECK(bytes == expected,
                std::to_string(bytes) + " bytes for " + std::to_string(expected));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(id_, 0, info.external, info.type, static_cast<GLsizei>(bytes), texels);
  throw_pending_gl_error(kReading);
}

void Texture::read_part(glm::ivec2 first, glm::ivec2 size, void* texels, std::size_t bytes,
                        int layer) const {
  const FormatInfo info = describe(format_);
  AMALGAM_CHECK(
      bytes == static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * info.bytes,
      std::to_string(bytes) + " bytes for a part of " + std::to_string(size.x) + "x" +
          std::to_string(size.y));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureSubImage(id_, 0, first.x, first.y, layer, size.x, size.y, 1, info.external, info.type,
                       static_cast<GLsizei>(bytes), texels);
  throw_pending_gl_error(kReading);
}

void Texture::clear_part(glm::ivec2 first, glm::ivec2 size, float value) const {
  const FormatInfo info = describe(format_);
  AMALGAM_CHECK(!is_array() && info.type == GL_FLOAT, "clear of a part that is not float");
  const std::array<GLfloat, 4> values{value, value, value, value};
  glClearTexSubImage(id_, 0, first.x, first.y, 0, size.x, size.y, 1, info.external, info.type,
                     values.data());
}

void Texture::set_zero_outside() {
  constexpr std::array<GLfloat, 4> kZero{};
  glTextureParameteri(id_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTextureParameteri(id_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  glTextureParameterfv(id_, GL_TEXTURE_BORDER_COLOR, kZero.data());
}

void Texture::bind(GLuint unit) const {
  glBindTextureUnit(unit, id_);
}

}  // namespace amalgam::gl
