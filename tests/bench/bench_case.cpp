#include "bench/bench_case.h"

#include <memory>

#include "client/synthetic/synthetic_camera.h"
#include "codec/jpeg.h"
#include "frame/default_view.h"
#include "scene/gltf/loader.h"

namespace amalgam::bench {
namespace {

constexpr int kMarker = 40;  // of all scenes of the bench, and of the synthetic desk

// Making the desk takes some tenths of a second, and all cases show the same.
std::shared_ptr<const client::SyntheticDesk> desk() {
  static const auto shared =
      std::make_shared<const client::SyntheticDesk>(client::PrintedMarker{.id = kMarker});
  return shared;
}

}  // namespace

common::MarkerPose bunny_pose() {
  return {kMarker, glm::dquat(0.3826834324, 0.9238795325, 0.0, 0.0), {0.0, 0.035, 0.16}};
}

void set_pose(BenchCase& bench_case, const common::MarkerPose& pose) {
  const client::SyntheticCamera camera(bench_case.camera, desk());
  bench_case.input = {codec::encode_jpeg(camera.render(pose), kCameraJpegQuality), {pose}};
}

BenchCase BenchScenes::load(const std::string& name, const std::string& file, int width,
                            int height) const {
  BenchCase result;
  result.name = name + " " + std::to_string(width) + "x" + std::to_string(height);
  result.scene_path = folder_ / file;
  if (!std::filesystem::exists(result.scene_path)) {
    throw MissingScene(result.scene_path.string() +
                       " is not there: deploy/fetch_assets.sh bunny makes the bunnies");
  }
  result.scene = scene::load_scene(result.scene_path);
  result.camera = common::default_camera(width, height);
  return result;
}

BenchCase BenchScenes::glass_bunny(int width, int height) const {
  BenchCase result = load("glass bunny", "generated/bunny-glass.gltf", width, height);
  set_pose(result, bunny_pose());
  return result;
}

BenchCase BenchScenes::mirror_bunny(int width, int height) const {
  BenchCase result = load("mirror bunny", "generated/bunny-mirror.gltf", width, height);
  set_pose(result, bunny_pose());
  return result;
}

BenchCase BenchScenes::complex(int width, int height) const {
  return on_desk("complex", "complex.gltf", width, height);
}

BenchCase BenchScenes::on_desk(const std::string& name, const std::string& file, int width,
                               int height) const {
  BenchCase result = load(name, file, width, height);
  set_pose(result, frame::default_pose(kMarker));
  return result;
}

}  // namespace amalgam::bench
