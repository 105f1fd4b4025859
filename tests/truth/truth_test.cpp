// How near a composite comes to reality: to a path-traced picture of the same scene with the
// virtual objects in it.
#include <gtest/gtest.h>

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <map>
#include <tuple>

#include "support/compare_images.h"
#include "support/test_output.h"
#include "truth/truth_figures.h"
#include "truth/truth_limits.h"
#include "truth/truth_rendering.h"

namespace amalgam::truth {
namespace {

const std::string kCameraAlone = "camera image alone";

// Of one picture by one method.
struct Row {
  std::string pair, method;
  Figures objects, real;
};

struct WorstPicture {
  double error = -1.0;
  std::string name;
  common::ImageRgb8 actual, truth;
};

void print_header() {
  std::cout << std::left << std::setw(40) << "truth" << std::setw(20) << "method" << std::right
            << "   objects: mean   95 %   SSIM    real: mean   95 %   SSIM  pixels   noise\n";
}

void print(const Row& row, double noise) {
  const auto put = [](const Figures& figures) {
    std::cout << std::setw(14) << std::setprecision(1) << figures.mean << std::setw(7)
              << figures.percentile_95 << std::setw(7) << std::setprecision(3) << figures.ssim;
  };
  std::cout << std::left << std::setw(40) << row.pair << std::setw(20) << row.method << std::right
            << std::fixed << "  ";
  put(row.objects);
  put(row.real);
  std::cout << std::setw(8) << row.real.pixels << std::setw(8) << std::setprecision(1) << noise
            << '\n';
}

// The composites of one pair, and the camera's image alone as the last.
std::vector<Row> compare_pair(const TruthPair& pair, const common::ImageRgb8& mask,
                              const std::vector<Method>& all,
                              const std::vector<common::ImageRgb8>& composites) {
  std::vector<const common::ImageRgb8*> pictures{&pair.truth};
  for (const common::ImageRgb8& composite : composites) pictures.push_back(&composite);
  const PixelSet objects = object_pixels(mask);
  const PixelSet real = changed_pixels(mask, pair.camera, pictures);
  std::vector<Row> rows;
  const auto add = [&](const std::string& method, const common::ImageRgb8& picture) {
    rows.push_back({pair.name, method, compare(picture, pair.truth, objects),
                    compare(picture, pair.truth, real)});
  };
  for (std::size_t i = 0; i < all.size(); ++i) add(all[i].name, composites[i]);
  add(kCameraAlone, pair.camera);
  return rows;
}

void keep_worse(const Row& row, const common::ImageRgb8& composite, const TruthPair& pair,
                WorstPicture& worst) {
  const double error = row.objects.mean + row.real.mean;
  if (error > worst.error) worst = {error, pair.name, composite, pair.truth};
}

// Gives the number of limits that there are.
std::size_t expect_within_limits(const std::string& name, const Row& row) {
  std::size_t found = 0;
  for (const Limit& limit : kLimits) {
    if (limit.truth_case != name || limit.method != row.method) continue;
    ++found;
    EXPECT_LE(row.objects.mean, limit.objects) << row.pair << ", " << row.method << ": objects";
    EXPECT_LE(row.real.mean, limit.real) << row.pair << ", " << row.method << ": real surfaces";
  }
  return found;
}

// The composites of each pair; all pairs are of one environment. A thread has one OpenGL context at
// a time, so one method after the other renders everything.
std::vector<common::ImageRgb8> composites_by(const Method& method, const TruthCase& truth_case,
                                             const std::vector<TruthPair>& pairs) {
  std::vector<common::ImageRgb8> composites;
  TruthRenderer renderer(truth_case, method);
  renderer.light_by(pairs.front().environment);
  for (const TruthPair& pair : pairs) composites.push_back(renderer.composite(pair.camera));
  return composites;
}

class Truth : public testing::TestWithParam<std::tuple<TruthCase, Environment>> {};

TEST_P(Truth, CompositesAreAsNearAsTheyWere) {
  const auto& [truth_case, environment] = GetParam();
  if (!std::filesystem::exists(truth_case.scene_path)) {
    GTEST_SKIP() << truth_case.scene_path << " is missing: deploy/fetch_assets.sh makes it";
  }
  std::vector<TruthPair> pairs;
  for (const char* kind : kKinds) pairs.push_back(load_pair(truth_case, environment, kind));
  const common::ImageRgb8 mask = load_mask(truth_case);
  const std::vector<Method> all{by_default(), with_64_lights(), of_the_thesis()};
  std::vector<std::vector<common::ImageRgb8>> composites(pairs.size());  // by pair, then method
  for (const Method& method : all) {
    std::vector<common::ImageRgb8> made = composites_by(method, truth_case, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) composites[i].push_back(std::move(made[i]));
  }

  WorstPicture worst;                          // by the default settings
  std::map<std::string, double> direct_error;  // on real surfaces, by method
  std::size_t limits = 0;
  print_header();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::vector<Row> rows = compare_pair(pairs[i], mask, all, composites[i]);
    for (const Row& row : rows) {
      print(row, pairs[i].noise);
      limits += expect_within_limits(truth_case.name, row);
      if (row.pair.find("direct") != std::string::npos) direct_error[row.method] = row.real.mean;
    }
    keep_worse(rows.front(), composites[i].front(), pairs[i], worst);
  }
  EXPECT_EQ(limits, 2 * pairs.size()) << "a scene or a method without limits";
  // Shadows must be worth drawing: without them the same truth would be further away. Not under an
  // overcast sky, whose soft shadows on red cloth are lighter than ours are too red.
  if (environment.name != "overcast") {
    EXPECT_LT(direct_error.at("64 lights"), direct_error.at(kCameraAlone));
  }
  std::cout << "the worst, " << worst.name << ":\n"
            << test_support::write_test_output("worst", test_support::as_floats(worst.actual),
                                               test_support::as_floats(worst.truth), 255.0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Truth,
                         testing::Combine(testing::ValuesIn(truth_cases()),
                                          testing::ValuesIn(environments())),
                         [](const auto& info) {
                           std::string name =
                               std::get<0>(info.param).name + "_" + std::get<1>(info.param).name;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace amalgam::truth
