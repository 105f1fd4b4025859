// Every buffer and the pass list of each scene of ours, against what was once looked at and found
// right.
//
// AMALGAM_REFRESH_GOLDENS=1 writes them anew. A failure leaves expected, actual and difference
// pictures in test_output of the build folder.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>
#include <map>
#include <sstream>

#include "codec/exr.h"
#include "frame/default_view.h"
#include "frame/frame_renderer.h"
#include "scene/gltf/loader.h"
#include "support/compare_images.h"

namespace amalgam {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 64, kHeight = 48;
const fs::path kExpected = AMALGAM_SOURCE_DIR "/tests/golden/expected";

bool refresh() {
  return std::getenv("AMALGAM_REFRESH_GOLDENS") != nullptr;
}

common::ImageRgb8 camera_image() {
  common::ImageRgb8 image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      image.at(x, y) = common::Rgb8(100 + 2 * x, 220 - 2 * y, (x / 6 + y / 6) % 2 == 0 ? 90 : 160);
    }
  }
  return image;
}

// Infinite depth becomes 0.
common::ImageRgb32f as_grey(const common::Image32f& values) {
  common::ImageRgb32f image(values.width(), values.height());
  for (std::size_t i = 0; i < values.pixels().size(); ++i) {
    const float value = values.pixels()[i];
    image.pixels()[i] = glm::vec3(std::isfinite(value) ? value : 0.0f);
  }
  return image;
}

// A buffer as colors, and its alpha or channels, if it has any, as others.
std::map<std::string, common::ImageRgb32f> as_colors(const frame::FrameBuffers& buffers) {
  std::map<std::string, common::ImageRgb32f> colors;
  for (const auto& [name, buffer] : buffers) {
    if (const auto* rgb = std::get_if<common::ImageRgb32f>(&buffer)) {
      // A reflection of the sun is a hundred times as bright as all else: moved by a thousandth of
      // a pixel it would outweigh the picture.
      constexpr float kWhite = 4.0f;
      colors[name] = *rgb;
      for (glm::vec3& color : colors[name].pixels()) color = glm::min(color, glm::vec3(kWhite));
    } else if (const auto* grey = std::get_if<common::Image32f>(&buffer)) {
      colors[name] = as_grey(*grey);
    } else if (const auto* channels = std::get_if<frame::Channels>(&buffer)) {
      for (const auto& [channel, values] : *channels)
        colors[name + "_" + channel] = as_grey(values);
    } else {
      const auto& rgba = std::get<common::ImageRgba32f>(buffer);
      common::ImageRgb32f color(rgba.width(), rgba.height()), alpha(rgba.width(), rgba.height());
      for (std::size_t i = 0; i < rgba.pixels().size(); ++i) {
        color.pixels()[i] = glm::vec3(rgba.pixels()[i]);
        alpha.pixels()[i] = glm::vec3(rgba.pixels()[i].w);
      }
      colors[name] = std::move(color);
      colors[name + "_alpha"] = std::move(alpha);
    }
  }
  return colors;
}

// Arithmetic of other processors (Mesa and Embree by SSE2 alone) moves colors by up to 5e-6 and
// depths by up to 1e-7.
//
// With it, an edge of an object or a shadow may fall on the other side of a sample, which changes
// that pixel by anything. None did in those runs, but few may: they are set aside, and a mistake
// that changes fewer pixels than that is not seen here.
constexpr std::size_t kEdgePixels = 4;  // of 3072

using test_support::Tolerance;
const Tolerance kRadiance = {5e-4, 1e-5, "scene-linear, up to 4: rounding", kEdgePixels};
const Tolerance kDisplay = {2e-4, 5e-6, "display-linear, up to 1: rounding", kEdgePixels};
const Tolerance kDepth = {1e-5, 1e-6, "of the depth buffer: rounding", kEdgePixels};
const Tolerance kShare = {1e-4, 1e-6, "shares of a pixel's light: rounding", kEdgePixels};
const Tolerance kMask = {0.0, 0.0, "counts of samples, so exact", kEdgePixels};

// A buffer that is new needs a line here.
const std::map<std::string, Tolerance> kTolerances = {
    {"mixed", kRadiance},
    {"real", kRadiance},
    {"environment_reflection", kDisplay},
    {"over", kDisplay},
    {"difference", kDisplay},
    {"light_ratio", kDisplay},
    {"real_depth", kDepth},
    {"over_alpha", kMask},
    {"virtual_mask", kMask},
    {"tracing_mask", kMask},
    {"provenance_camera_lookup", kShare},
    {"provenance_cut_off", kShare},
    {"provenance_environment", kShare},
    {"provenance_modelled_real", kShare},
    {"provenance_raster", kShare},
    {"provenance_traced_virtual", kShare},
};

std::string pass_list(const frame::FrameOutput& output) {
  std::ostringstream text;
  for (const frame::PassRecord& pass : output.statistics.passes) {
    text << pass.name << ": " << (pass.ran ? "ran" : pass.reason) << "\n";
  }
  return text.str();
}

void check_text(const fs::path& path, const std::string& actual) {
  if (refresh()) {
    std::ofstream(path) << actual;
    return;
  }
  std::stringstream expected;
  expected << std::ifstream(path).rdbuf();
  EXPECT_EQ(actual, expected.str()) << path;
}

class Golden : public testing::TestWithParam<const char*> {};

TEST_P(Golden, BuffersAndPassListsAreTheSame) {
  const std::string name = GetParam();
  frame::RendererSettings settings;
  settings.exposure = 0.5f;
  frame::FrameRenderer renderer(
      scene::load_scene(AMALGAM_SOURCE_DIR "/deploy/scenes/" + name + ".gltf"), settings);
  frame::ViewState view({.camera = common::default_camera(kWidth, kHeight), .keep_pixels = true});
  const frame::FrameInput input{camera_image(),
                                {frame::default_pose(renderer.scene().world.marker)}};
  frame::FrameBuffers buffers;
  const frame::FrameOutput first = renderer.render(view, input, &buffers);
  const frame::FrameOutput second = renderer.render(view, input);

  const fs::path folder = kExpected / name;
  if (refresh()) fs::create_directories(folder);
  check_text(folder / "passes-first-frame.txt", pass_list(first));
  check_text(folder / "passes-later-frame.txt", pass_list(second));
  for (const auto& [buffer, image] : as_colors(buffers)) {
    const fs::path file = folder / (buffer + ".exr");
    if (refresh()) {
      codec::write_exr(file, image);
      continue;
    }
    ASSERT_TRUE(fs::exists(file)) << file;
    ASSERT_TRUE(kTolerances.contains(buffer)) << buffer;
    EXPECT_TRUE(
        test_support::images_agree(buffer, image, codec::read_exr(file), kTolerances.at(buffer)));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::Values("complex", "diffuse", "mirror"),
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace
}  // namespace amalgam
