#include "frame/renderer_settings.h"

#include <gtest/gtest.h>

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
}

TEST(RendererMode, IsParsedByName) {
  EXPECT_EQ(parse_renderer_mode("raytrace"), RendererMode::Raytrace);
  EXPECT_THROW(parse_renderer_mode("fast"), std::invalid_argument);
}

}  // namespace
}  // namespace amalgam::frame
