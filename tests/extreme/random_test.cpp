// Random cases: traced against the reference, rasterised against it too, and what is real only
// changes no byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "extreme/random_case.h"
#include "parity/parity_row.h"
#include "parity/rendering.h"

namespace amalgam::extreme {
namespace {

using parity::ParityRow;

constexpr std::uint64_t kBatches = 20;

// A number from the environment, or what is given.
std::uint64_t setting(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

// Of seeds 1 to 2000, four pixels of 1.4 million are wrong and not among those that the reference
// calls grazing: one each of seeds 301, 558, 867 and 1265. Their cause is not known. In each of
// them the camera is in glass within glass, where a path meets up to ten facets.
constexpr std::size_t kMostWrongOfACase = 1;
constexpr double kMostWrongOfAll = 2e-5;  // of the pixels of a batch of 100 cases or more
// The rasteriser's depth knows one point a pixel, so that look-ups past things smaller than that
// may see what is hidden; shadow maps have texels.
constexpr double kMostLookUpsWrong = 0.02, kMostCompositeWrong = 0.03;

parity::Rendering render(const parity::ParityCase& parity_case, frame::RendererMode mode) {
  frame::RendererSettings settings;
  settings.mode = mode;
  settings.trace_shadow_edges = true;
  return parity::render(parity_case, settings);
}

bool has_virtual(const scene::Scene& scene) {
  return std::any_of(scene.instances.begin(), scene.instances.end(),
                     [](const auto& instance) { return instance.role == scene::Role::Virtual; });
}

struct Totals {
  std::size_t cases = 0, compared = 0, excused = 0, wrong = 0;
};

void check_traced(const RandomCase& random, const reference::ReferenceImages& expected,
                  Totals& totals) {
  constexpr auto kMode = frame::RendererMode::Raytrace;
  const ParityRow row =
      parity::compare_rendering(render(random.parity_case, kMode), expected, kMode);
  EXPECT_EQ(row.nonfinite, 0u) << random.text;
  EXPECT_LE(row.traced_wrong, kMostWrongOfACase) << random.text << row.worst;
  totals.compared += row.traced;
  totals.excused += row.edge + row.steep;
  totals.wrong += row.traced_wrong;
  if (row.traced_wrong > 0) std::cout << "traced: " << random.text << row.worst << '\n';
}

void check_hybrid(const RandomCase& random, const reference::ReferenceImages& expected) {
  constexpr auto kMode = frame::RendererMode::Hybrid;
  const ParityRow row =
      parity::compare_rendering(render(random.parity_case, kMode), expected, kMode);
  const auto pixels = static_cast<double>(row.pixels);
  EXPECT_EQ(row.nonfinite, 0u) << random.text;
  EXPECT_LE(static_cast<double>(row.traced_wrong), kMostLookUpsWrong * pixels)
      << "hybrid: " << random.text << row.worst;
  EXPECT_LE(static_cast<double>(row.composite_wrong), kMostCompositeWrong * pixels)
      << "hybrid: " << random.text;
}

// Invariant: nothing virtual, nothing changed.
void check_unchanged(RandomCase random, frame::RendererMode mode) {
  for (scene::Instance& instance : random.parity_case.scene.instances) {
    instance.role = scene::Role::Real;
  }
  EXPECT_TRUE(render(random.parity_case, mode).composite == random.parity_case.camera_image)
      << "all of it real: " << random.text;
}

class RandomCases : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomCases, AgreeWithTheReference) {
  const std::uint64_t count = setting("AMALGAM_RANDOM_CASES", 100);
  const std::uint64_t first = setting("AMALGAM_RANDOM_FIRST", 1);
  std::cout << "seeds from " << first << " on, " << count
            << " cases in all; nightly: AMALGAM_RANDOM_CASES=2000; one alone: "
               "AMALGAM_RANDOM_FIRST=SEED AMALGAM_RANDOM_CASES=1\n";
  Totals totals;
  for (std::uint64_t i = GetParam(); i < count; i += kBatches) {
    const RandomCase random = make_random_case(first + i);
    ++totals.cases;
    check_unchanged(random, frame::RendererMode::Raytrace);
    if (!has_virtual(random.parity_case.scene)) continue;
    reference::ReferenceRequest request = parity::make_reference_request(random.parity_case);
    request.find_grazing = true;
    const auto expected = reference::render_reference(random.parity_case.scene, request);
    check_traced(random, expected, totals);
    // Setting up a rasteriser takes longer than all the rest.
    if (i / kBatches % 10 == 0) check_hybrid(random, expected);
  }
  std::cout << totals.cases << " cases, " << totals.compared << " pixels compared, "
            << totals.excused << " of them grazing, " << totals.wrong << " wrong\n";
  if (totals.cases >= 100) {
    EXPECT_LE(static_cast<double>(totals.wrong),
              kMostWrongOfAll * static_cast<double>(totals.compared));
  }
}

INSTANTIATE_TEST_SUITE_P(Batches, RandomCases, testing::Range(std::uint64_t{0}, kBatches));

}  // namespace
}  // namespace amalgam::extreme
