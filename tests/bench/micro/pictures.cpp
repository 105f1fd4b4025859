// What is done to whole pictures, at 1280x1024.
#include "bench/bench_case.h"
#include "bench/micro/benchmarks.h"
#include "client/synthetic/synthetic_camera.h"
#include "codec/jpeg.h"
#include "passes/image/composite.h"

namespace amalgam::bench {
namespace {

constexpr int kWidth = 1280, kHeight = 1024;
constexpr int kQuality = 90;

const common::ImageRgb8& desk_picture() {
  static const common::ImageRgb8 picture =
      client::SyntheticCamera(common::default_camera(kWidth, kHeight)).render(bunny_pose());
  return picture;
}

void count_pixels(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * kWidth * kHeight);
}

}  // namespace

// An eighth of the picture is virtual, as with the bunny.
void benchmark_composite(benchmark::State& state) {
  core::Layers layers({kWidth, kHeight});
  for (int y = kHeight / 2; y < kHeight * 5 / 8; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      layers.set(x, y, {{0.3f, 0.4f, 0.5f, 1.0f}, glm::vec3(0.0f)});
    }
  }
  const common::ImageRgb8& camera_image = desk_picture();
  for (auto _ : state) benchmark::DoNotOptimize(passes::composite(layers, camera_image));
  count_pixels(state);
}

void benchmark_decode(benchmark::State& state) {
  const auto jpeg = codec::encode_jpeg(desk_picture(), kQuality);
  for (auto _ : state) benchmark::DoNotOptimize(codec::decode_jpeg(jpeg));
  count_pixels(state);
}

void benchmark_encode(benchmark::State& state) {
  const common::ImageRgb8& picture = desk_picture();
  for (auto _ : state) benchmark::DoNotOptimize(codec::encode_jpeg(picture, kQuality));
  count_pixels(state);
}

}  // namespace amalgam::bench
