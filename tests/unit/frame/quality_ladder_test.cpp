#include "frame/quality_ladder.h"

#include <gtest/gtest.h>

#include <vector>

namespace amalgam::frame {
namespace {

RendererSettings settings_of(int samples, int depth, float cutoff, float scale) {
  RendererSettings settings;
  settings.samples_per_pixel = samples;
  settings.trace.max_depth = depth;
  settings.trace.importance_cutoff = cutoff;
  settings.render_scale = scale;
  settings.coarse_allowed = true;
  return settings;
}

// Whatever the operator asked for is the best there is, and each level is less in one thing only.
TEST(QualityLadder, OnlyEverLess) {
  RendererSettings adaptive;
  adaptive.adaptive_threshold = 0.03f;
  adaptive.trace_shadow_edges = true;
  for (const RendererSettings& settings :
       {RendererSettings{}, settings_of(16, 30, 0.001f, 1.0f), settings_of(9, 5, 0.3f, 0.8f),
        settings_of(1, 2, 0.9f, 0.3f), settings_of(4, 0, 0.0f, 1.0f), adaptive}) {
    const auto ladder = make_quality_ladder(settings);
    const RendererSettings best = with_quality(settings, ladder.front(), settings.jpeg_quality);
    EXPECT_EQ(best.samples_per_pixel, settings.samples_per_pixel);
    EXPECT_EQ(best.trace.max_depth, settings.trace.max_depth);
    EXPECT_EQ(best.trace.importance_cutoff, settings.trace.importance_cutoff);
    EXPECT_EQ(best.render_scale, settings.render_scale);
    EXPECT_EQ(best.adaptive_threshold, settings.adaptive_threshold);
    for (std::size_t i = 1; i < ladder.size(); ++i) {
      const QualityLevel &better = ladder[i - 1], &level = ladder[i];
      EXPECT_NO_THROW(check_settings(with_quality(settings, level, 90)));
      EXPECT_LE(level.samples_per_pixel, better.samples_per_pixel);
      EXPECT_LE(level.max_depth, better.max_depth);
      EXPECT_GE(level.importance_cutoff, better.importance_cutoff);
      EXPECT_LE(level.render_scale, better.render_scale);
      EXPECT_LE(level.trace_cost, better.trace_cost);
      EXPECT_LE(level.raster_cost, better.raster_cost);
      const int differences = (level.samples_per_pixel != better.samples_per_pixel) +
                              (level.max_depth != better.max_depth) +
                              (level.importance_cutoff != better.importance_cutoff) +
                              (level.render_scale != better.render_scale) +
                              (level.adaptive_threshold != better.adaptive_threshold) +
                              (level.trace_shadow_edges != better.trace_shadow_edges);
      EXPECT_EQ(differences, 1) << i;
    }
  }
}

TEST(QualityLadder, WhatIsPlainlySeenIsLoweredOnlyIfAllowed) {
  RendererSettings settings;
  const QualityLevel fine = make_quality_ladder(settings).back();
  EXPECT_EQ(fine.render_scale, settings.render_scale);
  EXPECT_EQ(fine.max_depth, 8);
  settings.coarse_allowed = true;
  const QualityLevel coarse = make_quality_ladder(settings).back();
  EXPECT_LT(coarse.render_scale, settings.render_scale);
  EXPECT_LT(coarse.max_depth, fine.max_depth);
}

// Shares of the operator's scale, and not of the level before.
TEST(QualityLadder, ScalesAreSharesOfTheOperators) {
  std::vector<float> scales;
  for (const QualityLevel& level : make_quality_ladder(settings_of(1, 2, 0.9f, 0.8f))) {
    if (scales.empty() || scales.back() != level.render_scale) scales.push_back(level.render_scale);
  }
  ASSERT_EQ(scales.size(), 4u);
  const float shares[] = {1.0f, 0.85f, 0.7f, 0.5f};
  for (std::size_t i = 0; i < scales.size(); ++i) EXPECT_FLOAT_EQ(scales[i], 0.8f * shares[i]);
}

TEST(QualityLadder, JpegIsNeverFinerThanAskedFor) {
  for (const int quality : {1, 60, 70, 90}) {
    const auto ladder = make_jpeg_ladder(quality);
    EXPECT_EQ(ladder.front().quality, quality);
    for (const JpegLevel& level : ladder) EXPECT_LE(level.quality, quality);
  }
}

}  // namespace
}  // namespace amalgam::frame
