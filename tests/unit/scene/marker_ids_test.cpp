#include "scene/marker_ids.h"

#include <gtest/gtest.h>

namespace amalgam::scene {
namespace {

TEST(MarkerIds, AreTheWorldMarkerAndThoseOfObjectsEachOnce) {
  Scene scene;
  scene.world.marker = 40;
  for (const auto& marker : {std::optional<int>{98}, std::optional<int>{}, std::optional<int>{7},
                             std::optional<int>{98}, std::optional<int>{40}}) {
    scene.instances.emplace_back().marker = marker;
  }
  EXPECT_EQ(marker_ids(scene), (std::vector<int>{40, 7, 98}));
}

}  // namespace
}  // namespace amalgam::scene
