// What random cases hold: they would find nothing if they held nothing.
#include "extreme/random_case.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace amalgam::extreme {
namespace {

TEST(RandomCase, IsTheSameForTheSameSeed) {
  const RandomCase once = make_random_case(7), again = make_random_case(7);
  EXPECT_EQ(once.text, again.text);
  ASSERT_EQ(once.parity_case.scene.meshes.size(), again.parity_case.scene.meshes.size());
  for (std::size_t i = 0; i < once.parity_case.scene.meshes.size(); ++i) {
    EXPECT_EQ(once.parity_case.scene.meshes[i].positions,
              again.parity_case.scene.meshes[i].positions);
  }
  EXPECT_NE(once.text.substr(8), make_random_case(8).text.substr(8));
}

// Counts of the first hundred that hold something.
std::size_t count(const std::string& words) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    found += make_random_case(seed).text.find(words) != std::string::npos ? 1 : 0;
  }
  return found;
}

TEST(RandomCase, HoldsAllKindsOfThings) {
  for (const char* words :
       {"real diffuse", "virtual diffuse", "real mirror", "virtual mirror", "real solid glass",
        "virtual solid glass", "real thin glass", "virtual thin glass", "n 1.0001", "n 1 ",
        "low dynamic range", "directional lamp", "point lamp", "spot lamp", "camera 1 degrees",
        "camera 170 degrees", "real floor"}) {
    EXPECT_GE(count(words), 3u) << words;
  }
}

TEST(RandomCase, CamerasAndPosesCanBeUsed) {
  float largest = 0.0f;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const parity::ParityCase parity_case = make_random_case(seed).parity_case;
    EXPECT_EQ(common::describe_defect(parity_case.camera), "") << seed;
    EXPECT_TRUE(common::is_usable(parity_case.poses.at(0))) << seed;
    for (const glm::vec3& p : parity_case.scene.meshes.back().positions) {
      largest = std::max(largest, std::abs(p.x));
    }
  }
  EXPECT_GT(largest, 50.0f);
}

}  // namespace
}  // namespace amalgam::extreme
