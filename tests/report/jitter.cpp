#include "report/jitter.h"

#include <glm/geometric.hpp>
#include <stdexcept>

#include "bench/render_rig.h"
#include "report/composites.h"
#include "report/picture_figures.h"
#include "tracking/square_pose.h"

namespace amalgam::report {
namespace {

tracking::SquareCorners corners_in_picture(const common::MarkerPose& pose, double marker_length,
                                           const common::CameraModel& camera) {
  const auto corners = tracking::project_square(pose, marker_length, camera);
  if (!corners) throw std::runtime_error("the camera does not see the marker");
  return *corners;
}

double mean_side(const tracking::SquareCorners& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += glm::distance(corners[i], corners[(i + 1) % corners.size()]);
  }
  return sum / static_cast<double>(corners.size());
}

}  // namespace

common::MarkerPose noisy_pose(const common::MarkerPose& true_pose, double marker_length,
                              const common::CameraModel& camera, double noise,
                              std::mt19937_64& random) {
  tracking::SquareCorners corners = corners_in_picture(true_pose, marker_length, camera);
  std::normal_distribution<double> normal(0.0, noise);
  if (noise > 0.0) {
    for (glm::dvec2& corner : corners) corner += glm::dvec2(normal(random), normal(random));
  }
  const auto solutions = tracking::solve_square(corners, marker_length, camera);
  if (solutions.empty()) throw std::runtime_error("no pose for the marker's noisy corners");
  const auto closeness = [&](const tracking::PoseSolution& solution) {
    return std::abs(glm::dot(solution.pose.rotation, true_pose.rotation));
  };
  common::MarkerPose pose =
      std::max_element(solutions.begin(), solutions.end(), [&](const auto& a, const auto& b) {
        return closeness(a) < closeness(b);
      })->pose;
  pose.marker = true_pose.marker;
  return pose;
}

JitterErrors measure_jitter(const std::string& scene_name, const bench::BenchCase& bench_case,
                            ReferenceStore& references, double exposure, const ReferenceSpec& spec,
                            int draws) {
  frame::RendererSettings settings = bench::default_settings();
  settings.exposure = static_cast<float>(exposure);
  bench::RenderRig rig(bench_case, settings);
  const common::ImageRgb8 camera_image = camera_image_of(bench_case.input);
  const common::MarkerPose& pose = bench_case.input.poses.front();
  const double length = bench_case.scene.world.marker_length;
  const common::ImageRgb32f& reference = references.composite(bench_case, exposure, spec);
  const Composites still =
      render_composites(rig, bench_case.input, camera_image, settings.render_scale);

  JitterErrors errors{.scene = scene_name, .draws = draws};
  const double tracker_scale = kTrackerWidth / bench_case.camera.width;
  errors.marker_pixels =
      tracker_scale * mean_side(corners_in_picture(pose, length, bench_case.camera));
  errors.rendering = mean_absolute_error(still.before_jpeg, reference);
  errors.jpeg = mean_absolute_error(still.after_jpeg, still.before_jpeg);
  std::mt19937_64 random(1);
  for (int i = 0; i < draws; ++i) {
    frame::FrameInput input = bench_case.input;
    input.poses = {
        noisy_pose(pose, length, bench_case.camera, kCornerNoise / tracker_scale, random)};
    const Composites moved = render_composites(rig, input, camera_image, settings.render_scale);
    errors.tracking += mean_absolute_error(moved.before_jpeg, still.before_jpeg) / draws;
    errors.together += mean_absolute_error(moved.after_jpeg, reference) / draws;
  }
  return errors;
}

}  // namespace amalgam::report
