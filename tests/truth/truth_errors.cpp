#include "truth/truth_errors.h"

#include <algorithm>
#include <filesystem>

#include "scene/light/tone_map.h"
#include "truth/truth_figures.h"

namespace amalgam::truth {
namespace {

common::ImageRgb8 balanced(const common::ImageRgb8& image, const glm::vec3& gains) {
  if (gains == glm::vec3(1.0f)) return image;
  const scene::ToneMap seen = scene::tone_map_of(1.0f), wanted{gains, seen.curve};
  common::ImageRgb8 result = image;
  for (common::Rgb8& pixel : result.pixels()) {
    pixel = scene::srgb_encode(
        scene::tone_map(scene::inverse_tone_map(scene::srgb_decode(pixel), seen), wanted));
  }
  return result;
}

Error error_of(const common::ImageRgb8& picture, const TruthPair& pair,
               const common::ImageRgb8& mask) {
  const PixelSet real = changed_pixels(mask, pair.camera, {&pair.truth, &picture});
  return {compare(picture, pair.truth, object_pixels(mask)).mean,
          compare(picture, pair.truth, real).mean};
}

}  // namespace

std::vector<TruthCase> cases_at_hand() {
  std::vector<TruthCase> cases = truth_cases();
  std::erase_if(cases, [](const TruthCase& truth_case) {
    return !std::filesystem::exists(truth_case.scene_path);
  });
  return cases;
}

ErrorByPair errors_of(const Method& method, const std::vector<std::string>& kinds,
                      const glm::vec3& gains, const std::vector<Environment>& lit_by) {
  ErrorByPair errors;
  for (const TruthCase& truth_case : cases_at_hand()) {
    TruthRenderer renderer(truth_case, method);
    const common::ImageRgb8 mask = load_mask(truth_case);
    for (const Environment& environment : lit_by) {
      renderer.light_by(environment);
      for (const std::string& kind : kinds) {
        TruthPair pair = load_pair(truth_case, environment, kind);
        pair.camera = balanced(pair.camera, gains);
        pair.truth = balanced(pair.truth, gains);
        errors[pair.name] = error_of(renderer.composite(pair.camera), pair, mask);
      }
    }
  }
  return errors;
}

ErrorByPair errors_of_camera(const std::vector<std::string>& kinds) {
  ErrorByPair errors;
  for (const TruthCase& truth_case : cases_at_hand()) {
    const common::ImageRgb8 mask = load_mask(truth_case);
    for (const Environment& environment : environments()) {
      for (const std::string& kind : kinds) {
        const TruthPair pair = load_pair(truth_case, environment, kind);
        errors[pair.name] = error_of(pair.camera, pair, mask);
      }
    }
  }
  return errors;
}

Error mean_of(const ErrorByPair& errors) {
  Error mean;
  for (const auto& [pair, error] : errors) {
    mean.objects += error.objects / static_cast<double>(errors.size());
    mean.real += error.real / static_cast<double>(errors.size());
  }
  return mean;
}

}  // namespace amalgam::truth
