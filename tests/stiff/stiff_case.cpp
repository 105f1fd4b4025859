#include "stiff/stiff_case.h"

#include "scene/gltf/loader.h"

namespace amalgam::stiff {

parity::ParityCase make_case(const test_support::StiffScene& scene, int width, int height) {
  parity::ParityCase result;
  result.name = scene.name;
  result.scene = scene::load_scene(scene.file);
  result.camera = scene.camera(width, height);
  result.camera_image = parity::make_camera_image(width, height);
  result.poses = {scene.pose};
  return result;
}

}  // namespace amalgam::stiff
