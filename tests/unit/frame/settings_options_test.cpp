#include "frame/settings_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "server/renderer_options.h"

namespace amalgam::frame {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

RendererSettings parsed(std::vector<std::string> words) {
  CLI::App app;
  RendererSettings settings;
  tools::add_renderer_options(app, settings);
  std::reverse(words.begin(), words.end());  // as CLI wants them
  app.parse(words);
  return settings;
}

// Every member that an option sets, each away from its default.
RendererSettings all_changed() {
  RendererSettings settings;
  settings.mode = RendererMode::Raytrace;
  settings.samples_per_pixel = 9;
  settings.trace_shadow_edges = true;
  settings.trace = {3, 0.1f + 0.2f, trace::FresnelModel::Exact};
  settings.env_lights = {scene::EnvLightOptions::Method::MedianCut, 33};
  settings.exposure = 1.0f / 3.0f;
  settings.threads = 5;
  settings.render_scale = 0.7f;
  settings.target_fps = 29.97;
  settings.coarse_allowed = true;
  return settings;
}

void expect_equal(const RendererSettings& a, const RendererSettings& b) {
  EXPECT_EQ(a.mode, b.mode);
  EXPECT_EQ(a.samples_per_pixel, b.samples_per_pixel);
  EXPECT_EQ(a.adaptive_threshold, b.adaptive_threshold);
  EXPECT_EQ(a.trace_shadow_edges, b.trace_shadow_edges);
  EXPECT_EQ(a.trace, b.trace);
  EXPECT_EQ(a.env_lights, b.env_lights);
  EXPECT_EQ(a.exposure, b.exposure);
  EXPECT_EQ(a.threads, b.threads);
  EXPECT_EQ(a.render_scale, b.render_scale);
  EXPECT_EQ(a.target_fps, b.target_fps);
  EXPECT_EQ(a.coarse_allowed, b.coarse_allowed);
}

TEST(SettingsOptions, DefaultsNeedNone) {
  EXPECT_THAT(settings_options({}), IsEmpty());
  EXPECT_EQ(settings_without_options({}), "");
}

TEST(SettingsOptions, OnlyWhatDiffersIsNamed) {
  RendererSettings settings;
  settings.trace.max_depth = 4;
  settings.exposure = 0.5f;
  EXPECT_THAT(settings_options(settings), ElementsAre("--max-depth", "4", "--exposure", "0.5"));
}

TEST(SettingsOptions, ParsedTheyGiveTheSettingsBack) {
  expect_equal(parsed(settings_options(all_changed())), all_changed());
  EXPECT_EQ(settings_options(all_changed()).size(), 23u);
  for (const auto mode : {RendererMode::Hybrid, RendererMode::Raytrace, RendererMode::Raster,
                          RendererMode::Diffuse}) {
    RendererSettings settings;
    settings.mode = mode;
    expect_equal(parsed(settings_options(settings)), settings);
  }
  for (const float threshold : {kDefaultAdaptiveThreshold, 0.1f, 1e-5f, 1.0f}) {
    RendererSettings settings;
    settings.adaptive_threshold = threshold;
    expect_equal(parsed(settings_options(settings)), settings);
  }
}

TEST(SettingsOptions, WhatNoOptionSaysIsSaid) {
  RendererSettings settings;
  settings.leave_out_tiles = false;
  settings.jpeg_quality = 70;
  EXPECT_THAT(settings_options(settings), IsEmpty());
  EXPECT_EQ(settings_without_options(settings), "leave_out_tiles is false, jpeg_quality is 70");
}

TEST(SettingsOptions, NumbersKeepTheirBits) {
  for (const double number : {0.1, 1.0 / 3.0, 1e-300, -2.5, 1e22}) {
    EXPECT_EQ(std::stod(exact_text(number)), number);
  }
  EXPECT_EQ(std::stof(exact_text(0.1f + 0.2f)), 0.1f + 0.2f);
  EXPECT_EQ(exact_text(0.5f), "0.5");
}

}  // namespace
}  // namespace amalgam::frame
