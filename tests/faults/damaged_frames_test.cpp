// Rows 14 and 15 with the real decoder and renderer: what a damaged frame costs, and what it shows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <chrono>
#include <future>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "codec/jpeg.h"
#include "faults/figure.h"
#include "frame/default_view.h"
#include "frame/render_thread.h"
#include "frame/scene_renderer.h"
#include "net/process_figures.h"
#include "support/damaged_jpeg.h"

namespace amalgam::test {
namespace {

using Clock = std::chrono::steady_clock;
using frame::Bytes;

constexpr int kWidth = 64, kHeight = 48;

frame::MakeRenderer renderer() {
  frame::RendererSettings settings;
  settings.mode = frame::RendererMode::Raytrace;
  return frame::renderer_of_file(AMALGAM_SOURCE_DIR "/deploy/scenes/diffuse.gltf", settings);
}

// One client's view: a frame in, its answer out.
class Eye {
 public:
  explicit Eye(frame::RenderThread& service)
      : service_(service),
        view_(service.open_view({.camera = common::default_camera(kWidth, kHeight)},
                                [this](std::uint64_t, frame::FrameResult result) {
                                  result_.set_value(std::move(result));
                                })) {}
  ~Eye() { service_.close_view(view_); }

  frame::FrameResult see(const Bytes& jpeg) {
    result_ = {};
    auto result = result_.get_future();
    service_.submit(view_, 1, {jpeg, {frame::default_pose(40)}});
    return result.get();
  }

 private:
  frame::RenderThread& service_;
  std::promise<frame::FrameResult> result_;
  frame::ViewId view_;
};

Bytes picture(const common::Rgb8& color) {
  common::ImageRgb8 image(kWidth, kHeight, color);
  for (int i = 0; i < kHeight; ++i) image.at(i, i) = common::Rgb8(255);  // something to encode
  return codec::encode_jpeg(image, 90);
}

TEST(DamagedFrames, HugeOnesAndManyScansAreRefusedAtTheHeader) {
  frame::RenderThread service(renderer());
  Eye eye(service);
  const Bytes good = picture(common::Rgb8(128));
  ASSERT_TRUE(std::holds_alternative<frame::FrameOutput>(eye.see(good)));
  struct Row {
    const char* what;
    Bytes jpeg;
    const char* reason;
  };
  const std::vector<Row> rows{
      {"65500 x 65500", test_support::with_size(good, 65500, 65500), "65500"},
      {"1000 scans", test_support::with_more_scans(good, 1000), "more scans"}};
  for (const Row& row : rows) {
    ::malloc_trim(0);
    const auto before = net::read_process_figures().resident_bytes;
    double fastest_ms = 1e9;  // of some, because others may have the processor in between
    for (int i = 0; i < 20; ++i) {
      const auto begin = Clock::now();
      const frame::FrameResult refused = eye.see(row.jpeg);
      fastest_ms = std::min(
          fastest_ms, std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
      const auto* failure = std::get_if<frame::FrameFailure>(&refused);
      ASSERT_NE(failure, nullptr) << row.what;
      EXPECT_EQ(failure->kind, frame::FrameFailure::Kind::BadImage);
      EXPECT_THAT(failure->what, testing::HasSubstr(row.reason));
    }
    const auto after = net::read_process_figures().resident_bytes;
    const double grown =
        (static_cast<double>(after) - static_cast<double>(before)) / (1024.0 * 1024.0);
    print_figure("14", std::string(row.what) + " refused in", fastest_ms, "ms", "< 1 ms");
    print_figure("14", std::string(row.what) + " took", grown, "MiB", "+0");
    EXPECT_LT(fastest_ms, 1.0);
    EXPECT_LT(grown, 0.5);  // a picture of that size takes 12 GiB
  }
}

// Cut at each hundredth, and with single bits turned.
std::vector<Bytes> damaged(const Bytes& good) {
  std::vector<Bytes> all;
  for (std::size_t percent = 1; percent < 100; ++percent) {
    all.emplace_back(good.begin(),
                     good.begin() + static_cast<std::ptrdiff_t>(good.size() * percent / 100));
  }
  std::mt19937 random(5);
  for (int i = 0; i < 150; ++i) {
    Bytes flipped = good;
    const std::size_t bit = random() % (8 * good.size());
    flipped[bit / 8] ^= std::byte{1} << (bit % 8);
    all.push_back(std::move(flipped));
  }
  return all;
}

std::size_t magenta_pixels(const Bytes& jpeg) {
  const common::ImageRgb8 image = codec::decode_jpeg(jpeg);
  std::size_t count = 0;
  for (const common::Rgb8& pixel : image.pixels()) {
    count += pixel.x > 200 && pixel.y < 80 && pixel.z > 200;
  }
  return count;
}

// Each answer of B, with A's frames before them or without.
std::vector<std::string> answers(bool with_magenta, std::size_t& magenta) {
  frame::RenderThread service(renderer());
  Eye a(service), b(service);
  const Bytes bright = picture(common::Rgb8(255, 0, 255));
  std::vector<std::string> all;
  for (const Bytes& jpeg : damaged(picture(common::Rgb8(60, 120, 60)))) {
    if (with_magenta) {
      const auto seen = std::get<frame::FrameOutput>(a.see(bright));
      EXPECT_GT(magenta_pixels(seen.jpeg), 100u) << "A itself sees what it sent";
    }
    const frame::FrameResult result = b.see(jpeg);
    if (const auto* output = std::get_if<frame::FrameOutput>(&result)) {
      // What is returned as it came was never decoded, so nothing of anybody's is in it.
      if (!output->unchanged) magenta += magenta_pixels(output->jpeg);
      all.emplace_back(reinterpret_cast<const char*>(output->jpeg.data()), output->jpeg.size());
    } else {
      all.push_back(std::get<frame::FrameFailure>(result).what);
    }
  }
  return all;
}

TEST(DamagedFrames, ShowNothingOfAnotherClient) {
  std::size_t alone_magenta = 0, beside_magenta = 0;
  const auto alone = answers(false, alone_magenta), beside = answers(true, beside_magenta);
  print_figure("15", "magenta pixels in B's composites", static_cast<double>(beside_magenta), "",
               "0");
  // A turned bit may make any color, but then it does so without A too.
  EXPECT_EQ(beside_magenta, alone_magenta);
  ASSERT_EQ(alone.size(), beside.size());
  std::size_t differing = 0, shown = 0;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    differing += alone[i] != beside[i];
    shown += alone[i].compare(0, 2, "\xff\xd8") == 0;
  }
  EXPECT_EQ(differing, 0u) << "of " << alone.size();
  print_figure("15", "damaged frames shown all the same", static_cast<double>(shown), "", "any");
  EXPECT_GT(shown, 10u) << "or nothing was tested";
}

}  // namespace
}  // namespace amalgam::test
