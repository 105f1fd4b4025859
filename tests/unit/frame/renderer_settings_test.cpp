#include "frame/renderer_settings.h"

#include <gtest/gtest.h>

#include <limits>

namespace amalgam::frame {
namespace {

TEST(RendererSettings, DefaultsAreFine) {
  EXPECT_NO_THROW(check_settings({}));
}

TEST(RendererSettings, NonsenseIsRefused) {
  const auto refused = [](auto change) {
    RendererSettings settings;
    change(settings);
    EXPECT_THROW(check_settings(settings), std::invalid_argument);
  };
  refused([](auto& s) { s.samples_per_pixel = 2; });
  refused([](auto& s) { s.trace.max_depth = -1; });
  refused([](auto& s) { s.trace.importance_cutoff = 1.0f; });
  refused([](auto& s) { s.exposure = 0.0f; });
  refused([](auto& s) { s.threads = -1; });
  refused([](auto& s) { s.jpeg_quality = 101; });
  refused([](auto& s) { s.render_scale = 0.0f; });
  refused([](auto& s) { s.render_scale = 1.01f; });
  refused([](auto& s) { s.render_scale = std::numeric_limits<float>::quiet_NaN(); });
  refused([](auto& s) { s.target_fps = 0.0; });
  refused([](auto& s) { s.target_fps = -30.0; });
  refused([](auto& s) { s.target_fps = std::numeric_limits<double>::infinity(); });
}

TEST(RendererSettings, SamplesAreParsed) {
  RendererSettings settings;
  parse_samples("adaptive", settings);
  EXPECT_EQ(settings.samples_per_pixel, 1);
  EXPECT_EQ(settings.adaptive_threshold, kDefaultAdaptiveThreshold);
  parse_samples("adaptive:0.1", settings);
  EXPECT_EQ(settings.adaptive_threshold, 0.1f);
  parse_samples("9", settings);
  EXPECT_EQ(settings.samples_per_pixel, 9);
  EXPECT_FALSE(settings.adaptive_threshold);
  for (const char* wrong : {"", "2", "9x", "adaptive:", "adaptive:0", "adaptive:2", "adaptivex"}) {
    EXPECT_THROW(parse_samples(wrong, settings), std::invalid_argument) << wrong;
  }
}

TEST(RendererMode, IsParsedByName) {
  EXPECT_EQ(parse_renderer_mode("raytrace"), RendererMode::Raytrace);
  EXPECT_THROW(parse_renderer_mode("fast"), std::invalid_argument);
}

}  // namespace
}  // namespace amalgam::frame
