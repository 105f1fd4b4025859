// Camera, poses and meshes mean the same to Cycles and to us: otherwise every other figure of this
// folder would be one of shifted pictures.
#include <gtest/gtest.h>

#include <filesystem>

#include "truth/truth_rendering.h"

namespace amalgam::truth {
namespace {

class TruthGeometry : public testing::TestWithParam<TruthCase> {};

// Cycles' shares are of 64 samples in the pixel's square, ours is one at its centre. Where the
// whole square sees objects, or none of it does, both must agree. Smooth normals and the order of
// triangles do not matter to a silhouette, so there is nothing to set aside.
TEST_P(TruthGeometry, SilhouettesAgreeToAPixel) {
  if (!std::filesystem::exists(GetParam().scene_path)) {
    GTEST_SKIP() << GetParam().scene_path << " is missing: deploy/fetch_assets.sh makes it";
  }
  const common::ImageRgb8 expected = load_mask(GetParam());
  TruthRenderer renderer(GetParam(), by_default());
  renderer.light_by(environments().front());
  const common::Image32f actual =
      renderer.virtual_mask(load_pair(GetParam(), environments().front(), kKinds[0]).camera);
  ASSERT_EQ(actual.size(), expected.size());
  int inside = 0, outside = 0, rim = 0;
  for (int y = 0; y < actual.height(); ++y) {
    for (int x = 0; x < actual.width(); ++x) {
      const common::Rgb8 share = expected.at(x, y);
      // A real mirror that shows a virtual object counts as virtual, for eq. 4.5.
      if (share.g > 0) continue;
      const bool is_virtual = actual.at(x, y) > 0.5f;
      if (share.r == 255) {
        ++inside;
        EXPECT_TRUE(is_virtual) << "(" << x << ", " << y << ") should see an object";
      } else if (share.r == 0) {
        ++outside;
        EXPECT_FALSE(is_virtual) << "(" << x << ", " << y << ") should see no object";
      } else {
        ++rim;
      }
    }
  }
  // The comparison means something: objects fill a part of the picture, and most of it is no rim.
  EXPECT_GT(inside, 300);
  EXPECT_GT(outside, 3000);
  EXPECT_LT(rim, inside);
}

INSTANTIATE_TEST_SUITE_P(Scenes, TruthGeometry, testing::ValuesIn(truth_cases()),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace amalgam::truth
