#include "gl/texture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "gl/egl_context.h"

namespace amalgam::gl {
namespace {

TEST(Texture, GivesBackWhatWasUploaded) {
  const EglContext context;
  Texture texture(TextureFormat::Rgba8ui, {5, 3});  // rows that are no multiple of anything
  std::vector<std::uint8_t> bytes(5 * 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(7 * i + 1);
  texture.upload(bytes.data());
  std::vector<std::uint8_t> back(bytes.size());
  texture.read(back.data(), back.size());
  EXPECT_EQ(back, bytes);
}

TEST(Texture, ThrowsBeyondTheLimits) {
  const EglContext context;
  EXPECT_THROW(Texture(TextureFormat::R8ui, {1 << 20, 1}), std::runtime_error);
  EXPECT_THROW(Texture(TextureFormat::R8ui, {0, 1}), std::runtime_error);
  EXPECT_THROW(Texture(TextureFormat::Depth32f, {1, 1}, 1 << 20), std::runtime_error);
}

TEST(Texture, MovesWithItsDescription) {
  const EglContext context;
  Texture a(TextureFormat::Rgba32f, {4, 2});
  const GLuint id = a.id();
  Texture b(TextureFormat::R8ui, {1, 1});
  b = std::move(a);
  EXPECT_EQ(b.id(), id);
  EXPECT_EQ(b.size(), glm::ivec2(4, 2));
  EXPECT_EQ(b.format(), TextureFormat::Rgba32f);

  Texture array(TextureFormat::Depth32f, {2, 2}, 3);
  Texture made(std::move(array));
  EXPECT_EQ(made.layers(), 3);
  b = std::move(made);
  EXPECT_EQ(b.layers(), 3);
}

}  // namespace
}  // namespace amalgam::gl
