#include "parity/parity_case.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>

#include "scene/anchored_scene.h"
#include "scene/gltf/loader.h"
#include "support/scene_builders.h"

namespace amalgam::parity {
namespace {

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

// world_from_marker in glTF's axes.
common::MarkerPose make_pose(int marker, const glm::dmat4& world_from_marker) {
  const glm::dmat4 camera_from_world =
      test_support::look_at({0.03, 0.27, 0.24}, {-0.005, 0.015, -0.08});
  return test_support::make_pose(marker, camera_from_world * world_from_marker);
}

// The n-th other marker lies beside the world marker, to the right and to the left by turns, turned
// and a little off the table, as a measured one.
glm::dmat4 make_place(int n) {
  const double side = n % 2 == 0 ? 1.0 : -1.0;
  const glm::dvec3 beside(side * (0.09 + 0.03 * n), 0.0015 * (n + 1), 0.02 - 0.03 * n);
  return glm::rotate(glm::translate(glm::dmat4(1.0), beside), 0.3 * (n + 1) * side,
                     glm::dvec3(0.05, 1.0, -0.03));
}

}  // namespace

common::ImageRgb8 make_camera_image(int width, int height) {
  common::ImageRgb8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width, v = (y + 0.5) / height;
      const double stripe = 25.0 * std::sin(2.0 * reference::kPi * (6.0 * u + 2.0 * v));
      image.at(x, y) = {to_byte(70.0 + 110.0 * u + stripe), to_byte(90.0 + 90.0 * v - stripe),
                        to_byte(170.0 - 80.0 * u * v + stripe)};
    }
  }
  return image;
}

std::string scene_path(const std::string& scene_name) {
  std::string path = AMALGAM_SOURCE_DIR "/deploy/scenes/";
  path.append(scene_name).append(".gltf");
  return path;
}

ParityCase make_parity_case(const std::string& scene_name, int width, int height) {
  ParityCase result;
  result.name = scene_name.substr(scene_name.rfind('/') + 1) + " " + std::to_string(width) + "x" +
                std::to_string(height);
  result.scene = scene::load_scene(scene_path(scene_name));
  result.camera = test_support::make_pinhole(width, height, 1.1 * width);
  place_camera(result);
  return result;
}

void place_camera(ParityCase& parity_case) {
  parity_case.camera_image = make_camera_image(parity_case.camera.width, parity_case.camera.height);
  std::set<int> others;
  for (const scene::Instance& instance : parity_case.scene.instances) {
    if (instance.marker) others.insert(*instance.marker);
  }
  others.erase(parity_case.scene.world.marker);
  parity_case.poses = {make_pose(parity_case.scene.world.marker, glm::dmat4(1.0))};
  for (const int marker : others) {
    const int n = static_cast<int>(parity_case.poses.size()) - 1;
    parity_case.poses.push_back(make_pose(marker, make_place(n)));
  }
}

ParityCase with_samples(ParityCase parity_case, int samples_per_side) {
  const std::string n = std::to_string(samples_per_side);
  parity_case.name += " " + n + "x" + n;
  parity_case.samples_per_side = samples_per_side;
  return parity_case;
}

reference::ReferenceRequest make_reference_request(const ParityCase& parity_case) {
  reference::ReferenceRequest request;
  request.camera = parity_case.camera;
  request.anchored = scene::anchor_scene(parity_case.scene, parity_case.poses);
  if (parity_case.scene.environment) {
    request.lights = scene::extract_lights(*parity_case.scene.environment, {});
  }
  request.lights.insert(request.lights.end(), request.anchored.punctual_lights.begin(),
                        request.anchored.punctual_lights.end());
  request.camera_image = &parity_case.camera_image;
  request.response.exposure = static_cast<double>(parity_case.exposure);
  request.settings.max_depth = parity_case.max_depth;
  request.settings.importance_cutoff = static_cast<double>(parity_case.importance_cutoff);
  request.samples_per_side = parity_case.samples_per_side;
  request.response.linear = parity_case.linear_response;
  request.settings.ratio = !parity_case.by_difference;
  if (parity_case.exact_fresnel) request.settings.fresnel = reference::Fresnel::Exact;
  return request;
}

const reference::ReferenceImages& reference_images(const ParityCase& parity_case) {
  static std::map<std::string, reference::ReferenceImages> rendered;
  const auto found = rendered.find(parity_case.name);
  if (found != rendered.end()) return found->second;
  reference::ReferenceRequest request = make_reference_request(parity_case);
  request.find_grazing = true;
  return rendered.emplace(parity_case.name, reference::render_reference(parity_case.scene, request))
      .first->second;
}

}  // namespace amalgam::parity
