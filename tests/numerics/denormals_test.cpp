// numerics B24: every thread that computes a frame counts denormal numbers as zero.
#include <gtest/gtest.h>

#include <cmath>

#include "core/flush_denormals.h"
#include "numerics/many_workers.h"
#include "parity/rendering.h"
#include "support/scene_builders.h"
#include "unit/trace/trace_shot.h"

namespace amalgam {
namespace {

// Not folded by the compiler.
float product(float a, float b) {
  volatile float x = a, y = b;
  return x * y;
}

TEST(Denormals, AreZeroWhileFlushed) {
  ASSERT_EQ(std::fpclassify(product(1e-30f, 1e-10f)), FP_SUBNORMAL);
  {
    const core::FlushDenormals flush;
    EXPECT_EQ(product(1e-30f, 1e-10f), 0.0f) << "a result";
    EXPECT_EQ(product(1e-40f, 1e10f), 0.0f) << "an operand";
    EXPECT_EQ(product(1e-30f, 1e-7f), 1e-37f) << "normal numbers stay";
  }
  EXPECT_EQ(std::fpclassify(product(1e-30f, 1e-10f)), FP_SUBNORMAL);
}

// The least radiance in I_m of a lamp that fills the picture, which all threads share.
float darkest_pixel(float radiance, int threads) {
  parity::ParityCase lamp;
  lamp.name = "lamp";
  lamp.scene.world.marker = 40;
  test_support::add_object(lamp.scene, test_support::make_floor(0.0f, 50.0f),
                           trace::emitter(radiance), scene::Role::Virtual);
  lamp.camera = common::default_camera(320, 240);
  parity::place_camera(lamp);
  frame::RendererSettings settings;
  settings.mode = frame::RendererMode::Raytrace;
  settings.threads = threads;
  const auto rendering = parity::render(lamp, settings);
  const auto& mixed = std::get<common::ImageRgb32f>(rendering.buffers.at("mixed"));
  float least = radiance, greatest = 0.0f;
  for (const glm::vec3& pixel : mixed.pixels()) {
    least = std::min(least, pixel.x);
    greatest = std::max(greatest, pixel.x);
  }
  EXPECT_EQ(least, greatest);
  return least;
}

TEST(Denormals, AreZeroInEveryThreadThatRenders) {
  const test_support::ManyWorkers many;
  for (const int threads : {1, 2, 16}) {
    EXPECT_EQ(darkest_pixel(1e-39f, threads), 0.0f) << threads;
    EXPECT_EQ(darkest_pixel(1e-37f, threads), 1e-37f) << threads;
  }
}

}  // namespace
}  // namespace amalgam
