// What is rendered in the bench: a scene, a camera and a picture of the desk taken by it, all
// fixed.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "common/camera_model.h"
#include "common/pose.h"
#include "frame/frame.h"
#include "scene/scene.h"

namespace amalgam::bench {

// A scene that is not there; says how to get it.
class MissingScene : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct BenchCase {
  std::string name;  // "glass bunny 1280x1024"
  std::filesystem::path scene_path;
  scene::Scene scene;
  common::CameraModel camera;  // 60 degrees wide
  frame::FrameInput input;     // the synthetic desk as a JPEG, and the pose that it is seen from
};

inline constexpr int kCameraJpegQuality = 90;  // of the cases' pictures, 1..100

// The pose that bunnies are seen from: they cover 12 to 13 % of the picture.
common::MarkerPose bunny_pose();

class BenchScenes {
 public:
  // folder: with complex.gltf, and generated/bunny-{glass,mirror}.gltf (deploy/fetch_assets.sh).
  explicit BenchScenes(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // All throw MissingScene, or scene::SceneError.
  BenchCase glass_bunny(int width, int height) const;
  BenchCase mirror_bunny(int width, int height) const;
  BenchCase complex(int width, int height) const;  // seen as by frame::default_pose
  // Any other scene of the folder on the world marker of the desk, seen as by frame::default_pose.
  BenchCase on_desk(const std::string& name, const std::string& file, int width, int height) const;

 private:
  BenchCase load(const std::string& name, const std::string& file, int width, int height) const;

  std::filesystem::path folder_;
};

// The case from another pose, with the desk's picture as seen from there.
void set_pose(BenchCase& bench_case, const common::MarkerPose& pose);

}  // namespace amalgam::bench
