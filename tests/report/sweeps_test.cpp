#include "report/sweeps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "frame/settings_options.h"
#include "report/report_scene.h"

namespace amalgam::report {
namespace {

using testing::IsSubsetOf;
using testing::IsSupersetOf;

bool is_default(const SweepPoint& point) {
  frame::RendererSettings settings;
  settings.exposure = point.settings.exposure;
  settings.threads = point.settings.threads;
  settings.reuse_still_frames = false;
  return point.jpeg_quality == 0 &&
         frame::settings_options(settings) == frame::settings_options(point.settings);
}

class EachKind : public testing::TestWithParam<bool> {
 protected:
  std::vector<SweepPoint> points_ = make_sweeps({.quick = GetParam(), .exposure = 2.0f});
};
INSTANTIATE_TEST_SUITE_P(Sweeps, EachKind, testing::Bool());

TEST_P(EachKind, NamesAreDistinct) {
  std::set<std::string> names;
  for (const SweepPoint& point : points_) {
    EXPECT_TRUE(names.insert(point.sweep + "/" + point.label).second) << point.label;
  }
}

TEST_P(EachKind, SettingsCanBeRendered) {
  for (const SweepPoint& point : points_) {
    EXPECT_NO_THROW(frame::check_settings(point.settings)) << point.sweep << " " << point.label;
    EXPECT_EQ(point.settings.exposure, 2.0f) << point.sweep;
    // Nothing moves from run to run, but in a sweep everything is rendered.
    EXPECT_FALSE(point.settings.reuse_still_frames) << point.sweep;
  }
}

// One knob at a time: the points of a sweep differ from the default, but for one.
TEST_P(EachKind, TheDefaultIsInItsSweep) {
  std::set<std::string> with_default;
  for (const SweepPoint& point : points_) {
    if (is_default(point)) {
      EXPECT_TRUE(with_default.insert(point.sweep).second) << point.sweep;
    }
  }
  for (const char* sweep : {"samples", "adaptive", "lights", "fresnel", "shadow edges",
                            "JPEG quality", "render scale", "joint"}) {
    EXPECT_TRUE(with_default.contains(sweep)) << sweep;
  }
}

// The limit differs from the point in the knob that is swept, and in nothing else.
TEST_P(EachKind, LimitsAreThePointsOwnButForTheKnob) {
  for (const SweepPoint& point : points_) {
    if (!point.limit) continue;
    ReferenceSpec spec = *point.limit;
    const auto& settings = point.settings;
    if (point.sweep != "samples") {
      EXPECT_EQ(spec.samples_per_side * spec.samples_per_side, settings.samples_per_pixel);
    } else {
      EXPECT_GT(spec.samples_per_side * spec.samples_per_side, settings.samples_per_pixel);
    }
    if (point.sweep != "depth") {
      EXPECT_EQ(spec.max_depth, settings.trace.max_depth) << point.sweep;
    } else {
      EXPECT_GT(spec.max_depth, settings.trace.max_depth);
    }
    const auto cutoff = static_cast<double>(settings.trace.importance_cutoff);
    if (point.sweep != "cut-off") {
      EXPECT_EQ(spec.importance_cutoff, cutoff) << point.sweep;
    } else {
      EXPECT_LE(spec.importance_cutoff, 0.1 * cutoff);
    }
    EXPECT_EQ(spec.env_lights == settings.env_lights, point.sweep != "lights") << point.sweep;
    EXPECT_FALSE(spec.exact_fresnel) << point.sweep;
  }
}

TEST(Sweeps, QuickIsAPartOfTheFullSweep) {
  const auto names = [](bool quick) {
    std::vector<std::string> all;
    for (const SweepPoint& point : make_sweeps({.quick = quick})) {
      all.push_back(point.sweep + " " + point.label);
    }
    return all;
  };
  EXPECT_THAT(names(true), IsSubsetOf(names(false)));
  EXPECT_THAT(sweep_names(), IsSupersetOf({"samples", "joint"}));
}

TEST(Sweeps, ReferencesSayWhatTheyAre) {
  EXPECT_EQ(to_string(best_reference(full_quality())),
            "16x16 samples, depth 64, cut-off 1e-04, exact Fresnel, lights sectors");
}

// Within half a pixel, and a new place from the previous ones at least half as far as the best of
// a square grid would be.
TEST(Places, FillThePixelEvenly) {
  EXPECT_EQ(sub_pixel_offset(0), glm::dvec2(0.0));
  constexpr int kCount = 20;
  for (int i = 0; i < kCount; ++i) {
    const glm::dvec2 place = sub_pixel_offset(i);
    EXPECT_LE(std::abs(place.x), 0.5);
    EXPECT_LE(std::abs(place.y), 0.5);
    for (int j = 0; j < i; ++j) {
      EXPECT_GT(glm::distance(place, sub_pixel_offset(j)), 0.5 / std::sqrt(kCount)) << i << j;
    }
  }
}

// Between mirrors the error after D bounces is r^D of the first one: depths and cut-offs for
// shares of it, and what is compared with follows rays to the end.
TEST_P(EachKind, MirrorsThatFaceEachOtherAreFollowedByTheirReflectance) {
  for (const double r : {0.5, 0.9, 0.99}) {
    for (const SweepPoint& point : make_sweeps(
             {.quick = GetParam(), .exposure = 1.0f, .stiff = true, .bounce_reflectance = r})) {
      if (point.sweep == "depth") {
        EXPECT_EQ(point.settings.trace.max_depth % 2, 0);
        const double share = std::pow(r, point.settings.trace.max_depth);
        EXPECT_LT(share, 0.101) << r;
        EXPECT_GT(share, 0.006 * r * r * 0.99) << r;
      } else {
        EXPECT_EQ(point.sweep, "cut-off");
        EXPECT_GE(point.settings.trace.max_depth, std::log(1e-4) / std::log(r));
      }
      EXPECT_NO_THROW(frame::check_settings(point.settings));
      EXPECT_GE(point.limit.value().max_depth, std::log(1e-6) / std::log(r));
    }
  }
}

TEST_P(EachKind, OtherStiffScenesHaveTwoSweeps) {
  std::set<std::string> names;
  for (const SweepPoint& point :
       make_sweeps({.quick = GetParam(), .exposure = 1.0f, .stiff = true})) {
    names.insert(point.sweep);
  }
  EXPECT_EQ(names, (std::set<std::string>{"cut-off", "depth"}));
}

}  // namespace
}  // namespace amalgam::report
