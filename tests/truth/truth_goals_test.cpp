// What the composites gain over the thesis's method (eq. 4.5 with eight lights), on direct light
// alone: against truth pictures without caustics and without light from one diffuse surface to
// another, which neither method has.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <map>

#include "scene/light/tone_map.h"
#include "truth/truth_figures.h"
#include "truth/truth_rendering.h"

namespace amalgam::truth {
namespace {

struct Error {
  double objects = 0.0, real = 0.0;  // mean differences, 1/255
};

using ErrorByPair = std::map<std::string, Error>;

Error mean_of(const ErrorByPair& errors) {
  Error mean;
  for (const auto& [pair, error] : errors) {
    mean.objects += error.objects / static_cast<double>(errors.size());
    mean.real += error.real / static_cast<double>(errors.size());
  }
  return mean;
}

void print(const std::string& method, const Error& mean) {
  std::cout << std::left << std::setw(20) << method << std::right << std::fixed
            << std::setprecision(2) << "  objects " << std::setw(6) << mean.objects << "  shadows "
            << std::setw(6) << mean.real << "  in 1/255\n";
}

// The same picture by a camera with these gains: its white balance.
common::ImageRgb8 balanced(const common::ImageRgb8& image, const glm::vec3& gains) {
  const scene::ToneMap seen = scene::tone_map_of(1.0f), wanted{gains, seen.curve};
  common::ImageRgb8 result = image;
  for (common::Rgb8& pixel : result.pixels()) {
    pixel = scene::srgb_encode(
        scene::tone_map(scene::inverse_tone_map(scene::srgb_decode(pixel), seen), wanted));
  }
  return result;
}

std::vector<TruthCase> cases_at_hand() {
  std::vector<TruthCase> cases = truth_cases();
  std::erase_if(cases, [](const TruthCase& truth_case) {
    return !std::filesystem::exists(truth_case.scene_path);
  });
  return cases;
}

// Every scene under every environment by these kinds of pictures.
ErrorByPair errors_of(const Method& method, const std::vector<std::string>& kinds,
                      const glm::vec3& gains = glm::vec3(1.0f)) {
  ErrorByPair errors;
  for (const TruthCase& truth_case : cases_at_hand()) {
    TruthRenderer renderer(truth_case, method);
    const common::ImageRgb8 mask = load_mask(truth_case);
    const PixelSet objects = object_pixels(mask);
    for (const Environment& environment : environments()) {
      renderer.light_by(environment);
      for (const std::string& kind : kinds) {
        TruthPair pair = load_pair(truth_case, environment, kind);
        pair.camera = balanced(pair.camera, gains);
        pair.truth = balanced(pair.truth, gains);
        const common::ImageRgb8 composite = renderer.composite(pair.camera);
        const PixelSet real = changed_pixels(mask, pair.camera, {&pair.truth, &composite});
        errors[pair.name] = {compare(composite, pair.truth, objects).mean,
                             compare(composite, pair.truth, real).mean};
      }
    }
  }
  return errors;
}

const std::vector<std::string> kDirect{"direct-linear", "direct-reinhard"};

TEST(TruthGoals, ShadowsAndObjectsAreNearerThanTheThesiss) {
  if (cases_at_hand().size() < truth_cases().size())
    GTEST_SKIP() << "scenes are missing: deploy/fetch_assets.sh makes them";
  const ErrorByPair ours = errors_of(with_64_lights(), kDirect);
  const ErrorByPair thesis = errors_of(of_the_thesis(), kDirect);
  const Error our_mean = mean_of(ours), thesis_mean = mean_of(thesis);
  print("64 lights", our_mean);
  print("eq. 4.5, 8 lights", thesis_mean);
  EXPECT_LE(our_mean.real, 6.0);
  EXPECT_LE(our_mean.real, thesis_mean.real / 3.0);
  EXPECT_LE(our_mean.objects, thesis_mean.objects / 2.0);
  for (const auto& [pair, error] : ours) {
    EXPECT_LE(error.objects, thesis.at(pair).objects) << pair;
    EXPECT_LE(error.real, thesis.at(pair).real) << pair;
  }
  // Each part alone brings something, over all pictures: to objects, to shadows, or to both.
  for (const Method& method : parts_off()) {
    const Error without = mean_of(errors_of(method, kDirect));
    print("without: " + method.name, without);
    EXPECT_GT(without.objects + without.real, our_mean.objects + our_mean.real) << method.name;
  }
}

// A camera that is balanced for other light than ours to be white.
TEST(TruthGoals, AWhiteBalancedCameraIsFollowed) {
  if (cases_at_hand().empty()) GTEST_SKIP() << "scenes are missing";
  const glm::vec3 gains(0.75f, 1.0f, 1.5f);
  Method off = by_default();
  off.settings.white_balance = false;
  const Error plain = mean_of(errors_of(by_default(), {"direct-reinhard"}));
  const Error followed = mean_of(errors_of(by_default(), {"direct-reinhard"}, gains));
  const Error ignored = mean_of(errors_of(off, {"direct-reinhard"}, gains));
  print("not balanced", plain);
  print("balanced", followed);
  print("balanced, without", ignored);
  EXPECT_LE(followed.objects, 1.1 * plain.objects);
  EXPECT_GE(ignored.objects, 1.2 * followed.objects);
}

}  // namespace
}  // namespace amalgam::truth
