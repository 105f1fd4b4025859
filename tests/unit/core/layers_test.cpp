#include "core/layers.h"

#include <gtest/gtest.h>

namespace amalgam::core {
namespace {

constexpr glm::ivec2 kSize(40, 20);  // no multiple of a tile's side

TEST(Layers, AreZeroUntilAnyLayerIsNot) {
  Layers layers(kSize);
  EXPECT_TRUE(layers.is_zero());
  layers.set(17, 3, {glm::vec4(0.0f), glm::vec3(0.0f)});
  EXPECT_TRUE(layers.is_zero()) << "a tile exists, but nothing is in it";
  layers.set(17, 3, {glm::vec4(0.0f), glm::vec3(0.0f, 0.0f, -1e-9f)});
  EXPECT_FALSE(layers.is_zero());
  // A black object covers and adds nothing.
  layers.set(17, 3, {glm::vec4(0.0f, 0.0f, 0.0f, 1.0f), glm::vec3(0.0f)});
  EXPECT_FALSE(layers.is_zero());
}

TEST(Layers, PixelsHaveTheirOwnPlaceInTheirTile) {
  Layers layers(kSize);
  for (int y = 0; y < kSize.y; ++y) {
    for (int x = 0; x < kSize.x; ++x) layers.set(x, y, {glm::vec4(x, y, 0, 1), glm::vec3(y, x, 1)});
  }
  EXPECT_EQ(layers.present().size(), 6u);
  for (int y = 0; y < kSize.y; ++y) {
    for (int x = 0; x < kSize.x; ++x) {
      EXPECT_EQ(layers.at(x, y).over, glm::vec4(x, y, 0, 1));
      EXPECT_EQ(layers.at(x, y).difference, glm::vec3(y, x, 1));
    }
  }
}

TEST(Layers, AddingAddsBothLayersAndTakesOverTiles) {
  Layers sum(kSize), other(kSize);
  sum.set(0, 0, {glm::vec4(1, 2, 3, 0.25f), glm::vec3(1, 2, 3)});
  other.set(0, 0, {glm::vec4(4, 5, 6, 0.5f), glm::vec3(-4, 5, 6)});
  other.set(39, 19, {glm::vec4(7, 8, 9, 1), glm::vec3(7, 8, 9)});
  sum.add(std::move(other));
  EXPECT_EQ(sum.at(0, 0).over, glm::vec4(5, 7, 9, 0.75f));
  EXPECT_EQ(sum.at(0, 0).difference, glm::vec3(-3, 7, 9));
  EXPECT_EQ(sum.at(39, 19).over, glm::vec4(7, 8, 9, 1));
  EXPECT_EQ(sum.at(39, 19).difference, glm::vec3(7, 8, 9));
}

TEST(Layers, CopiesAreTheirOwn) {
  Layers layers(kSize);
  layers.set(5, 5, {glm::vec4(1), glm::vec3(1)});
  const Layers copy = layers;
  layers.set(5, 5, {glm::vec4(0), glm::vec3(0)});
  EXPECT_EQ(copy.at(5, 5).over, glm::vec4(1));
  EXPECT_EQ(copy.at(5, 5).difference, glm::vec3(1));
}

// The right and the lower tiles reach beyond the picture.
TEST(TileGrid, TilesEndWithThePicture) {
  const TileGrid grid(kSize);
  EXPECT_EQ(grid.tiles(), glm::ivec2(3, 2));
  EXPECT_EQ(grid.tile_of(39, 19), 5u);
  EXPECT_EQ(grid.first_pixel(5), glm::ivec2(32, 16));
  EXPECT_EQ(grid.end_pixel(5), kSize);
  EXPECT_EQ(grid.end_pixel(0), glm::ivec2(16, 16));
}

}  // namespace
}  // namespace amalgam::core
