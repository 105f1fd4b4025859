#include "passes/image/refine.h"

#include <gtest/gtest.h>

#include <limits>

namespace amalgam::passes {
namespace {

constexpr int kWidth = 8, kHeight = 6;

core::Layers empty_layers() {
  return core::Layers({kWidth, kHeight});
}
trace::FirstHits one_surface() {
  return {common::Image<std::uint32_t>(kWidth, kHeight, 3u),
          common::Image32f(kWidth, kHeight, 1.0f)};
}
int count(const common::Image<std::uint8_t>& edges) {
  int marked = 0;
  for (const std::uint8_t edge : edges.pixels()) marked += edge;
  return marked;
}

TEST(FindEdges, NothingVirtualHasNoEdges) {
  trace::FirstHits hits = one_surface();
  hits.instance.at(4, 3) = 9;  // real objects have borders too, but add nothing to the picture
  hits.distance.at(1, 1) = std::numeric_limits<float>::infinity();
  EXPECT_EQ(count(find_edges(empty_layers(), &hits, 0.03f)), 0);
}

TEST(FindEdges, AStepInColorMarksBothSides) {
  core::Layers layers = empty_layers();
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 4; x < kWidth; ++x) layers.set(x, y, {glm::vec4(0.0f), glm::vec3(-0.1f)});
  }
  const auto edges = find_edges(layers, nullptr, 0.03f);
  EXPECT_EQ(count(edges), 2 * kHeight);
  EXPECT_EQ(edges.at(3, 2), 1);
  EXPECT_EQ(edges.at(4, 2), 1);
  EXPECT_EQ(count(find_edges(layers, nullptr, 0.2f)), 0) << "below the threshold";
}

TEST(FindEdges, AnotherObjectOrDistanceIsAnEdgeAtAnyColor) {
  core::Layers layers = empty_layers();
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      layers.set(x, y, {glm::vec4(0.3f, 0.3f, 0.3f, 1.0f), glm::vec3(0.0f)});
    }
  }
  trace::FirstHits hits = one_surface();
  hits.instance.at(4, 3) = 5;
  EXPECT_EQ(count(find_edges(layers, &hits, 0.03f)), 5) << "the pixel and its four neighbours";
  hits = one_surface();
  hits.distance.at(4, 3) = 1.5f;
  EXPECT_EQ(count(find_edges(layers, &hits, 0.03f)), 5);
  hits.distance.at(4, 3) = 1.01f;
  EXPECT_EQ(count(find_edges(layers, &hits, 0.03f)), 0) << "a slanted surface";
}

// An object that fills its tile exactly: its edges lie between that tile and its neighbours, in
// which there is nothing.
TEST(FindEdges, EdgesBetweenTilesAreFoundOnEachSide) {
  constexpr int kSide = core::kTileSide;
  core::Layers layers(glm::ivec2(3 * kSide));
  for (int y = kSide; y < 2 * kSide; ++y) {
    for (int x = kSide; x < 2 * kSide; ++x) layers.set(x, y, {glm::vec4(1.0f), glm::vec3(0.0f)});
  }
  const auto edges = find_edges(layers, nullptr, 0.03f);
  const int middle = kSide + kSide / 2;
  for (const int border : {kSide, 2 * kSide}) {
    for (const int side : {border - 1, border}) {
      EXPECT_EQ(edges.at(side, middle), 1) << side;
      EXPECT_EQ(edges.at(middle, side), 1) << side;
    }
  }
  EXPECT_EQ(count(edges), 4 * 2 * kSide - 4) << "a corner's two edges share its inner pixel";
}

}  // namespace
}  // namespace amalgam::passes
