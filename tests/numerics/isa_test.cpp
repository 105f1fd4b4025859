// numerics B11 and B25: how far pictures differ between Embree's instruction sets.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "numerics/icosphere.h"
#include "numerics/isa.h"
#include "support/compare_images.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

using test_support::ChosenIsa;

TEST(Isa, OnlyKnownSetsAreTaken) {
  const scene::Scene scene;
  {
    const ChosenIsa wrong("mmx");
    EXPECT_THROW(EmbreeScene{scene}, std::runtime_error);
  }
  {
    const ChosenIsa unset("");
    EXPECT_NO_THROW(EmbreeScene{scene});
  }
  EXPECT_FALSE(usable_isas().empty());
  for (const std::string& isa : usable_isas()) {
    const ChosenIsa chosen(isa);
    EXPECT_NO_THROW(EmbreeScene{scene}) << isa;
  }
}

// Single hits, before the tracer computes them again in double: the triangle, and its coordinates.
TEST(Isa, HitsDifferInTheirLastDigitsAlone) {
  scene::Scene scene;
  test_support::add_object(scene, test_support::make_icosphere(4), test_support::make_mirror(),
                           scene::Role::Virtual);
  std::map<std::string, std::vector<std::optional<Hit>>> hits;
  constexpr int kRays = 100'000;
  for (const std::string& isa : usable_isas()) {
    const ChosenIsa chosen(isa);
    EmbreeScene embree(scene);
    embree.place(anchor_all(scene));
    std::mt19937 random(13);
    std::normal_distribution<float> normal;
    for (int i = 0; i < kRays; ++i) {
      const glm::vec3 to(normal(random), normal(random), normal(random));
      const Ray ray{{0.1f, -0.2f, 0.3f}, glm::normalize(to), 10.0f};
      hits[isa].push_back(embree.intersect(ray, Visible::Everything));
    }
  }
  const auto& [first_isa, first] = *hits.begin();
  for (const auto& [isa, found] : hits) {
    int other_triangle = 0, other_digits = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_TRUE(found[i] && first[i]) << isa;
      const Hit &a = *found[i], &b = *first[i];
      if (a.triangle != b.triangle) {
        ++other_triangle;
        continue;
      }
      other_digits += a.t != b.t || a.barycentric != b.barycentric ? 1 : 0;
      largest =
          std::max({largest, std::abs(a.t - b.t), glm::distance(a.barycentric, b.barycentric)});
    }
    std::printf(
        "%s against %s: %d of %d hits are of another triangle, %d have other digits (%.2g)\n",
        isa.c_str(), first_isa.c_str(), other_triangle, kRays, other_digits, largest);
    EXPECT_LE(other_triangle, kRays / 100'000) << isa;
    EXPECT_LT(largest, 1e-4) << isa;
  }
  // Otherwise the choice has no effect, and nothing here is compared.
  if (hits.contains("sse4.2") && hits.contains("avx2")) {
    int different = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      different += hits["sse4.2"][i]->barycentric != hits["avx2"][i]->barycentric ? 1 : 0;
    }
    EXPECT_GT(different, 0);
  }
}

struct IsaDifference {
  std::size_t pixels = 0, of = 0;
  double largest = 0.0;
};

void add(IsaDifference& sum, const common::ImageRgb32f& a, const common::ImageRgb32f& b) {
  const auto compared = test_support::compare_images(a, b);
  sum.of += compared.compared;
  sum.largest = std::max(sum.largest, compared.maximum);
  for (const double d : compared.differences.pixels()) sum.pixels += d > 0.0 ? 1 : 0;
}

common::ImageRgb32f color_of(const common::ImageRgba32f& rgba) {
  common::ImageRgb32f rgb(rgba.width(), rgba.height());
  for (std::size_t i = 0; i < rgba.pixels().size(); ++i)
    rgb.pixels()[i] = glm::vec3(rgba.pixels()[i]);
  return rgb;
}

// A ball of glass and a mirror on a floor: rays bounce and refract up to ten times.
TEST(Isa, GlassAndMirrorsDifferInFewPixelsOnly) {
  const scene::Environment environment = constant_environment(0.5f);
  scene::Scene scene;
  using namespace test_support;
  add_object(scene, make_sphere({-0.4f, 0.5f, 0}, 0.5f, 64, 32), make_glass(),
             scene::Role::Virtual);
  add_object(scene, make_sphere({0.7f, 0.4f, 0.2f}, 0.4f, 64, 32), make_mirror(glm::vec3(0.9f)),
             scene::Role::Virtual);
  add_object(scene, make_floor(0.0f, 3.0f), make_diffuse({0.6f, 0.5f, 0.4f}), scene::Role::Real);
  const Shot shot{.eye = {0.3, 1.5, 3},
                  .target = {0, 0.4, 0},
                  .environment = &environment,
                  .lights = {make_sun({1, 2, 1})},
                  .width = 320,
                  .height = 240,
                  .focal_length = 300};
  std::map<std::string, TraceResult> results;
  for (const std::string& isa : usable_isas()) {
    const ChosenIsa chosen(isa);
    results.emplace(isa, trace_shot(scene, shot));
  }
  const auto& [first_isa, first] = *results.begin();
  for (const auto& [isa, result] : results) {
    IsaDifference difference;
    add(difference, color_of(result.layers.over_image()), color_of(first.layers.over_image()));
    add(difference, result.layers.difference_image(), first.layers.difference_image());
    std::printf("%s against %s: %zu of %zu pixels differ, by %g at most\n", isa.c_str(),
                first_isa.c_str(), difference.pixels, difference.of, difference.largest);
    EXPECT_LE(difference.pixels, difference.of / 100'000) << isa;
  }
}

}  // namespace
}  // namespace amalgam::trace
