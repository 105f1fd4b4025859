// What needs scenes and renderers: references, places of the camera, jitter, determinism.
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "bench/povray/temporary_folder.h"
#include "codec/exr.h"
#include "report/composites.h"
#include "report/content_hash.h"
#include "report/determinism.h"
#include "report/jitter.h"
#include "report/reference_store.h"
#include "report/report_scene.h"
#include "report/scene_meter.h"
#include "report/sweeps.h"
#include "report/whole_file.h"
#include "trace/embree_isa.h"

namespace amalgam::report {
namespace {

const std::filesystem::path kScenes = AMALGAM_SOURCE_DIR "/deploy/scenes";
constexpr ReferenceSpec kSmall{
    .samples_per_side = 2, .max_depth = 4, .importance_cutoff = 0.05, .env_lights = {}};

const bench::BenchCase& small_case() {
  static const bench::BenchCase made = bench::BenchScenes(kScenes).complex(48, 36);
  return made;
}

class References : public testing::Test {
 protected:
  ReferenceStore store() {
    return ReferenceStore(folder_.path(), [this](const std::string&) { ++rendered_; });
  }
  bench::TemporaryFolder folder_;
  int rendered_ = 0;
};

TEST_F(References, AreRenderedOnce) {
  ReferenceStore first = store();
  const common::ImageRgb32f picture = first.composite(small_case(), 1.0, kSmall);
  first.composite(small_case(), 1.0, kSmall);
  EXPECT_EQ(rendered_, 1);
  ReferenceStore second = store();
  EXPECT_EQ(second.composite(small_case(), 1.0, kSmall), picture);
  EXPECT_EQ(rendered_, 1);
}

// Whatever changes the picture changes the file.
TEST_F(References, AreOfWhatWasAskedFor) {
  ReferenceStore references = store();
  int expected = 0;
  const auto is_new = [&](const bench::BenchCase& bench_case, double exposure,
                          const ReferenceSpec& spec) {
    references.composite(bench_case, exposure, spec);
    return rendered_ == ++expected;
  };
  EXPECT_TRUE(is_new(small_case(), 1.0, kSmall));
  EXPECT_TRUE(is_new(small_case(), 2.0, kSmall));
  ReferenceSpec spec = kSmall;
  spec.exact_fresnel = !spec.exact_fresnel;
  EXPECT_TRUE(is_new(small_case(), 1.0, spec));
  EXPECT_TRUE(is_new(moved_by(small_case(), {0.25, 0.0}), 1.0, kSmall));
  bench::BenchCase other_pose = small_case();
  other_pose.input.poses[0].translation.x += 0.01;
  EXPECT_TRUE(is_new(other_pose, 1.0, kSmall));
}

TEST_F(References, DamagedFilesAreMadeAnew) {
  const common::ImageRgb32f picture = store().composite(small_case(), 1.0, kSmall);
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    EXPECT_EQ(entry.path().extension(), ".exr");
    std::filesystem::resize_file(entry.path(), 100);
  }
  EXPECT_EQ(store().composite(small_case(), 1.0, kSmall), picture);
  EXPECT_EQ(rendered_, 2);
}

TEST_F(References, TheFloorIsTheReferencesOwnError) {
  ReferenceStore references = store();
  ReferenceSpec finer = kSmall;
  finer.samples_per_side = 5;
  const double coarse = references.floor(small_case(), 1.0, kSmall);
  const double fine = references.floor(small_case(), 1.0, finer);
  EXPECT_GT(coarse, 2.0 * fine);
  EXPECT_GT(fine, 0.0);
  ReferenceSpec single = kSmall;
  single.samples_per_side = 1;
  EXPECT_TRUE(std::isnan(references.floor(small_case(), 1.0, single)));
}

TEST(SceneHash, IsOfTheFilesThatTheSceneNames) {
  const bench::TemporaryFolder folder;
  const auto gltf = folder.path() / "a.gltf";
  const auto write = [&](const char* name, const char* content) {
    std::ofstream(folder.path() / name, std::ios::trunc) << content;
  };
  write("a.gltf", R"({"buffers": [{"uri": "a.bin"}], "extras": {"environment": "hall.exr"}})");
  write("a.bin", "1");
  write("hall.exr", "2");
  write("other.bin", "3");
  const std::string first = scene_hash(gltf);
  write("other.bin", "changed");
  EXPECT_EQ(scene_hash(gltf), first);
  write("a.bin", "changed");
  const std::string second = scene_hash(gltf);
  EXPECT_NE(second, first);
  write("hall.exr", "changed");
  EXPECT_NE(scene_hash(gltf), second);
  EXPECT_THROW(scene_hash(folder.path() / "none.gltf"), std::runtime_error);
}

// FIPS 180-2: of "abc".
TEST(ContentHash, IsSha256) {
  const std::string abc = "abc";
  EXPECT_EQ(ContentHash().add(std::as_bytes(std::span(abc))).digest(),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(WholeFile, IsThereAsAWholeOrNotAtAll) {
  const bench::TemporaryFolder folder;
  const auto path = folder.path() / "a.txt";
  write_whole_file(path, "old");
  EXPECT_THROW(write_whole_file(path,
                                [](const std::filesystem::path& temporary) {
                                  std::ofstream(temporary) << "half";
                                  throw std::runtime_error("cut off");
                                }),
               std::runtime_error);
  EXPECT_EQ(read_whole_file(path), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  EXPECT_THROW(write_whole_file(folder.path() / "none" / "a.txt", "new"), std::runtime_error);
}

TEST(Jitter, WithoutNoiseThePoseIsTheTrueOne) {
  std::mt19937_64 random(1);
  const common::MarkerPose truth = small_case().input.poses[0];
  const common::CameraModel camera = common::default_camera(640, 480);
  const auto pose = noisy_pose(truth, 0.05, camera, 0.0, random);
  EXPECT_LT(glm::distance(pose.translation, truth.translation), 1e-5);
  EXPECT_GT(std::abs(glm::dot(pose.rotation, truth.rotation)), 1.0 - 1e-9);
  EXPECT_EQ(pose.marker, truth.marker);
}

// Sideways, the mean of four corners moves by noise / sqrt(4) pixels, and the marker by that times
// its distance over the focal length. Far more noise, or none, would not.
TEST(Jitter, MovesTheMarkerByHalfTheNoise) {
  std::mt19937_64 random(1);
  const common::MarkerPose truth = small_case().input.poses[0];
  const common::CameraModel camera = common::default_camera(640, 480);
  constexpr int kDraws = 400;
  double square = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const auto pose = noisy_pose(truth, 0.05, camera, kCornerNoise, random);
    const auto before = project(camera, truth.translation);
    const auto after = project(camera, pose.translation);
    ASSERT_TRUE(before && after);
    square += (after->x - before->x) * (after->x - before->x) / kDraws;
  }
  EXPECT_NEAR(std::sqrt(square), kCornerNoise / 2.0, 0.1 * kCornerNoise);
}

TEST_F(References, JitterHasItsParts) {
  ReferenceStore references = store();
  const JitterErrors errors =
      measure_jitter("complex", small_case(), references,
                     static_cast<double>(metered_exposure(small_case())), kSmall, 2);
  EXPECT_GT(errors.tracking, 0.0);
  EXPECT_GT(errors.rendering, 0.0);
  EXPECT_GT(errors.jpeg, 0.0);
  EXPECT_LE(errors.together, errors.tracking + errors.rendering + 2.0 * errors.jpeg);
  EXPECT_GE(errors.together, 0.5 * std::max(errors.tracking, errors.jpeg));
}

// Four numbers of threads, and each instruction set.
TEST(Determinism, ThreadsAndInstructionSetsDoNotShow) {
  const auto rows = measure_determinism("complex", small_case());
  ASSERT_EQ(rows.size(), 4u + trace::usable_isas().size());
  EXPECT_EQ(rows.back().what, trace::usable_isas().back());
  EXPECT_TRUE(is_deterministic(rows));
  for (const LayersHash& row : rows) EXPECT_EQ(row.differing_pixels, 0) << row.what;
}

TEST(Determinism, OneBitShows) {
  frame::FrameBuffers buffers{{"over", common::ImageRgba32f(4, 4, glm::vec4(0.5f))},
                              {"difference", common::ImageRgb32f(4, 4)}};
  const std::string before = layers_hash(buffers);
  auto& difference = std::get<common::ImageRgb32f>(buffers["difference"]);
  difference.at(3, 3).b = 1e-45f;
  EXPECT_NE(layers_hash(buffers), before);
  EXPECT_FALSE(
      is_deterministic({{"s", "1 thread", before, 0, 0.0}, {"s", "2 threads", "other", 1, 1e-45}}));
  EXPECT_TRUE(
      is_deterministic({{"s", "1 thread", before, 0, 0.0}, {"t", "1 thread", "other", 0, 0.0}}));
}

TEST_F(References, RunsHaveThePlacesInTurn) {
  ReferenceStore references = store();
  SceneMeter meter({.name = "complex", .load = {}, .move = moved_by}, small_case(), references, 1.0,
                   {.runs = 3, .places = 2});
  SweepPoint point;
  point.sweep = "samples";
  point.label = "1";
  point.settings = bench::default_settings();
  point.settings.exposure = 1.0f;
  point.reference = kSmall;
  point.limit = kSmall;
  const RunRow first = meter.measure(point, 0), second = meter.measure(point, 1),
               third = meter.measure(point, 2);
  EXPECT_EQ(first.offset, 0u);
  EXPECT_EQ(second.offset, 0u);
  EXPECT_EQ(third.offset, 1u);
  EXPECT_EQ(third.offset_x, sub_pixel_offset(1).x);
  EXPECT_EQ(first.mae, second.mae);
  EXPECT_NE(first.mae, third.mae);
  EXPECT_GT(first.limit_mae, 0.0);
  EXPECT_LT(first.limit_mae, 1.5 * first.mae);
  EXPECT_TRUE(std::isnan(third.limit_mae));
  // The same picture, one sample against four, in other renderers: edges alone differ.
  EXPECT_GT(first.mae, 0.0);
  EXPECT_LT(first.mae, 0.02);
  EXPECT_GT(first.ssim, 0.8);
  EXPECT_GT(first.time_ms, 0.0);
  EXPECT_GT(first.cpu_ms, 0.0);
  EXPECT_GT(first.rays_primary, 0u);
  EXPECT_GT(first.output_bytes, 0u);
  EXPECT_GT(first.jpeg_mae, 0.0);
  EXPECT_EQ(first.nonfinite, 0u);
}

// The moved camera sees everything moved by as much, itself and in its picture.
TEST(Places, MoveTheCamerasPictureToo) {
  const bench::BenchCase moved = moved_by(small_case(), {1.0, 0.0});
  EXPECT_EQ(moved.camera.cx, small_case().camera.cx + 1.0);
  const common::ImageRgb8 before = camera_image_of(small_case().input);
  const common::ImageRgb8 after = camera_image_of(moved.input);
  double same = 0.0, shifted = 0.0;
  for (int y = 0; y < before.height(); ++y) {
    for (int x = 1; x < before.width(); ++x) {
      same += std::abs(int{after.at(x, y).g} - int{before.at(x, y).g});
      shifted += std::abs(int{after.at(x, y).g} - int{before.at(x - 1, y).g});
    }
  }
  EXPECT_LT(shifted, 0.5 * same);
}

}  // namespace
}  // namespace amalgam::report
