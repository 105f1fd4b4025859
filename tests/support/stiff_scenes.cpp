#include "support/stiff_scenes.h"

#include <stdexcept>

#include "support/scene_builders.h"

namespace amalgam::test_support {
namespace {

using Kind = StiffScene::Kind;

constexpr int kMarker = 40;

struct Size {
  const char* name;
  double metres;
};
constexpr Size kSizes[] = {{"1mm", 1e-3}, {"1m", 1.0}, {"1km", 1e3}};

// Where the camera is and where it looks, for a scene of size 1.
struct View {
  glm::dvec3 eye, target;
  double focal_length;
};

View view_of(Kind kind) {
  switch (kind) {
    case Kind::Corridor:  // beside the vanishing point, so that it does not hide between pixels
      return {{0.0, 0.5, 0.0}, {0.03, 0.48, 1.0}, 1.5};
    case Kind::Stack:
      return {{0.0, 0.45, 0.85}, {0.0, 0.45, 0.0}, 1.1};
    case Kind::Ball:
    case Kind::Nested:
      return {{0.0, 0.55, 0.9}, {0.0, 0.4, 0.0}, 1.1};
    case Kind::Lens:
      return {{0.0, 0.55, 0.85}, {0.0, 0.4, 0.0}, 1.1};
  }
  throw std::logic_error("no view of this kind of scene");
}

common::MarkerPose pose_of(const View& view, double size) {
  return make_pose(kMarker, look_at(size * view.eye, size * view.target));
}

void add_sizes(std::vector<StiffScene>& scenes, const std::string& stem, Kind kind,
               double parameter) {
  const View view = view_of(kind);
  for (const Size& size : kSizes) {
    const std::string name = stem + "-" + size.name;
    scenes.push_back({.name = name,
                      .file = AMALGAM_SOURCE_DIR "/deploy/scenes/stiff/" + name + ".gltf",
                      .kind = kind,
                      .parameter = parameter,
                      .size = size.metres,
                      .pose = pose_of(view, size.metres),
                      .focal_length = view.focal_length});
  }
}

// numbers: as in the file names.
void add_series(std::vector<StiffScene>& scenes, const std::string& stem, Kind kind,
                const std::vector<std::string>& numbers) {
  for (const std::string& number : numbers) {
    add_sizes(scenes, stem + "-" + number, kind, std::stod(number));
  }
}

}  // namespace

common::CameraModel StiffScene::camera(int width, int height) const {
  return make_pinhole(width, height, focal_length * width);
}

std::vector<StiffScene> stiff_scenes() {
  std::vector<StiffScene> scenes;
  add_series(scenes, "corridor", Kind::Corridor, {"0.5", "0.8", "0.9", "0.95", "0.99", "0.999"});
  add_series(scenes, "stack", Kind::Stack, {"2", "4", "8", "16", "32", "64"});
  add_series(scenes, "ball", Kind::Ball, {"1.0001", "2.42"});
  add_sizes(scenes, "nested", Kind::Nested, 0.0);
  add_sizes(scenes, "lens", Kind::Lens, 0.0);
  return scenes;
}

StiffScene stiff_scene(const std::string& name) {
  for (const StiffScene& scene : stiff_scenes()) {
    if (scene.name == name) return scene;
  }
  throw std::out_of_range("no stiff scene " + name);
}

common::CameraModel narrow_camera(int side) {
  return make_pinhole(side, side, 1e5);
}

common::MarkerPose straight_pose(const StiffScene& scene) {
  View view = view_of(scene.kind);
  view.target = view.eye - glm::dvec3(0.0, 0.0, 1.0);
  return pose_of(view, scene.size);
}

// Each sheet reflects rho = 2R / (1 + R). N sheets that reflect so among each other transmit
// (1 - rho) / (1 + (N - 1) rho), which is (1 - R) / (1 + (2N - 1) R).
double stack_transmittance(double index, int sheets) {
  const double root = (index - 1.0) / (index + 1.0);
  const double r = root * root;
  return (1.0 - r) / (1.0 + (2.0 * sheets - 1.0) * r);
}

}  // namespace amalgam::test_support
