// What both renderers are given to draw: a scene that comes with Amalgam, a made-up camera image
// and a made-up pose.
#pragma once

#include <string>
#include <vector>

#include "common/camera_model.h"
#include "common/image.h"
#include "common/pose.h"
#include "scene/light/env_lights.h"
#include "scene/scene.h"
#include "support/reference/reference_renderer.h"

namespace amalgam::parity {

struct ParityCase {
  std::string name;  // "complex 160x120"
  scene::Scene scene;
  common::CameraModel camera;
  common::ImageRgb8 camera_image;
  std::vector<common::MarkerPose> poses;
  float exposure = 1.0f;
  int samples_per_side = 1;
  bool exact_fresnel = false;
  bool by_difference = false;    // real surfaces as in eq. 4.5, otherwise by ratio
  bool linear_response = false;  // of the camera, otherwise Reinhard's
  int max_depth = 10;
  // Below the renderer's default, so that more of the tracer is compared.
  float importance_cutoff = 0.004f;
};

// Of deploy/scenes.
std::string scene_path(const std::string& scene_name);

// A scene of deploy/scenes. The image is gradients and soft stripes by formula; the world marker
// is seen from above at a slant, as by somebody at a desk, the scene's other markers beside it.
ParityCase make_parity_case(const std::string& scene_name, int width, int height);

// Gradients and soft stripes.
common::ImageRgb8 make_camera_image(int width, int height);

// The made-up image, of the camera's size, and the poses.
void place_camera(ParityCase& parity_case);

// The same with n x n samples a pixel.
ParityCase with_samples(ParityCase parity_case, int samples_per_side);

// The case as the reference is asked for it. The case must outlive the request.
reference::ReferenceRequest make_reference_request(const ParityCase& parity_case);

// With grazing pixels found. Rendered once for each name and kept: both modes of the renderer are
// compared with it.
const reference::ReferenceImages& reference_images(const ParityCase& parity_case);

}  // namespace amalgam::parity
