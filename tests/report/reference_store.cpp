#include "report/reference_store.h"

#include <cstring>
#include <limits>
#include <utility>

#include "codec/exr.h"
#include "codec/jpeg.h"
#include "report/content_hash.h"
#include "report/float_composite.h"
#include "report/picture_figures.h"
#include "report/whole_file.h"
#include "scene/anchored_scene.h"
#include "support/reference/reference_renderer.h"

namespace amalgam::report {
namespace {

// To be counted up when the reference renderer gives other pictures than before.
constexpr double kReferenceVersion = 1;

const frame::Bytes& camera_jpeg(const bench::BenchCase& bench_case) {
  return std::get<frame::Bytes>(bench_case.input.image);
}

void add_camera(ContentHash& hash, const common::CameraModel& camera) {
  hash.add(camera.width).add(camera.height);
  for (const double value : {camera.fx, camera.fy, camera.cx, camera.cy}) hash.add(value);
  for (const double value : camera.distortion) hash.add(value);
}

void add_pose(ContentHash& hash, const common::MarkerPose& pose) {
  const auto& q = pose.rotation;
  const auto& t = pose.translation;
  hash.add(pose.marker);
  for (const double value : {q.x, q.y, q.z, q.w, t.x, t.y, t.z}) hash.add(value);
}

common::ImageRgb32f render(const bench::BenchCase& bench_case, double exposure,
                           const ReferenceSpec& spec) {
  const common::ImageRgb8 camera_image = codec::decode_jpeg(camera_jpeg(bench_case));
  reference::ReferenceRequest request;
  request.camera = bench_case.camera;
  request.anchored = scene::anchor_scene(bench_case.scene, bench_case.input.poses);
  if (bench_case.scene.environment) {
    request.lights = scene::extract_lights(*bench_case.scene.environment, spec.env_lights);
  }
  request.lights.insert(request.lights.end(), request.anchored.punctual_lights.begin(),
                        request.anchored.punctual_lights.end());
  request.camera_image = &camera_image;
  request.response.exposure = exposure;
  request.samples_per_side = spec.samples_per_side;
  request.settings.max_depth = spec.max_depth;
  request.settings.importance_cutoff = spec.importance_cutoff;
  if (spec.exact_fresnel) request.settings.fresnel = reference::Fresnel::Exact;
  return float_composite(reference::render_reference(bench_case.scene, request).layers,
                         camera_image);
}

}  // namespace

ReferenceStore::ReferenceStore(std::filesystem::path folder,
                               std::function<void(const std::string&)> rendering)
    : folder_(std::move(folder)), rendering_(std::move(rendering)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw std::runtime_error(folder_.string() + ": " + error.message());
}

std::string ReferenceStore::file_name(const bench::BenchCase& bench_case, double exposure,
                                      const ReferenceSpec& spec) {
  auto& scene = scenes_[bench_case.scene_path];
  if (scene.empty()) scene = scene_hash(bench_case.scene_path);
  ContentHash hash;
  hash.add(kReferenceVersion).add(scene).add(exposure).add(to_string(spec));
  add_camera(hash, bench_case.camera);
  for (const common::MarkerPose& pose : bench_case.input.poses) add_pose(hash, pose);
  hash.add(camera_jpeg(bench_case));
  std::string name = bench_case.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  constexpr std::size_t kDigits = 16;
  return name + "-" + hash.digest().substr(0, kDigits) + ".exr";
}

const common::ImageRgb32f& ReferenceStore::composite(const bench::BenchCase& bench_case,
                                                     double exposure, const ReferenceSpec& spec) {
  const std::string name = file_name(bench_case, exposure, spec);
  const auto found = pictures_.find(name);
  if (found != pictures_.end()) return found->second;
  const std::filesystem::path path = folder_ / name;
  common::ImageRgb32f picture;
  try {
    if (std::filesystem::exists(path)) picture = codec::read_exr(path);
  } catch (const codec::ExrError&) {
    // Damaged: made again.
  }
  if (picture.size() != glm::ivec2(bench_case.camera.width, bench_case.camera.height)) {
    rendering_("reference of " + bench_case.name + ": " + to_string(spec));
    picture = render(bench_case, exposure, spec);
    write_whole_file(path, [&](const auto& temporary) { codec::write_exr(temporary, picture); });
  }
  return pictures_.emplace(name, std::move(picture)).first->second;
}

double ReferenceStore::floor(const bench::BenchCase& bench_case, double exposure,
                             const ReferenceSpec& spec) {
  if (spec.samples_per_side < 2) return std::numeric_limits<double>::quiet_NaN();
  ReferenceSpec other = spec;
  --other.samples_per_side;
  return mean_absolute_error(composite(bench_case, exposure, other),
                             composite(bench_case, exposure, spec));
}

}  // namespace amalgam::report
