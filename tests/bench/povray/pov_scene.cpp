#include "bench/povray/pov_scene.h"

#include <fstream>
#include <glm/matrix.hpp>
#include <numbers>
#include <stdexcept>

#include "bench/povray/pov_material.h"
#include "bench/povray/pov_text.h"
#include "codec/exr.h"
#include "common/pose.h"
#include "scene/anchored_scene.h"
#include "scene/light/env_lights.h"

namespace amalgam::bench {
namespace {

void write_settings(std::ostream& out, const trace::TraceSettings& settings) {
  // POV-Ray counts the camera's ray as a level.
  out << "#version 3.7;\n"
      << "global_settings { assumed_gamma 1 ambient_light 0 max_trace_level "
      << settings.max_depth + 1 << " adc_bailout " << settings.importance_cutoff << " }\n";
}

// POV-Ray's picture is spanned by `right` and `up` at the distance of `direction`.
void write_camera(std::ostream& out, const common::CameraModel& camera,
                  const glm::dmat4& camera_from_world) {
  const glm::dmat4 world_from_camera = common::rigid_inverse(camera_from_world);
  const glm::dvec3 x(world_from_camera[0]), y(world_from_camera[1]), z(world_from_camera[2]);
  const double off_x = (0.5 * (camera.width - 1) - camera.cx) / camera.fx;
  const double off_y = (0.5 * (camera.height - 1) - camera.cy) / camera.fy;
  out << "camera { perspective location " << pov_vector(glm::dvec3(world_from_camera[3]))
      << " direction " << pov_vector(z + off_x * x + off_y * y) << " right "
      << pov_vector(x * (camera.width / camera.fx)) << " up "
      << pov_vector(-y * (camera.height / camera.fy)) << " }\n";
}

// POV-Ray's diffuse term lacks the 1/pi of ours. Directional lights only: that is what an
// environment gives.
void write_light(std::ostream& out, const scene::Light& light) {
  constexpr double kFarAway = 100.0;  // metres
  if (light.kind != scene::Light::Kind::Directional) {
    throw std::runtime_error("only directional lights are written for POV-Ray");
  }
  out << "light_source { " << pov_vector(kFarAway * glm::dvec3(light.to_light)) << " color rgb "
      << pov_vector(glm::dvec3(light.intensity) / std::numbers::pi)
      << " parallel point_at <0, 0, 0> }\n";
}

// The map's centre looks along +Z in ours; a quarter of a turn brings POV-Ray's there.
void write_environment(std::ostream& out, const scene::Environment& environment,
                       const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "environment.exr";
  codec::write_exr(file, environment.radiance);
  out << "sky_sphere { pigment { image_map { exr \"" << file.string()
      << "\" map_type 1 interpolate 2 } rotate 90 * y } }\n";
}

void write_mesh(std::ostream& out, const scene::Mesh& mesh, const scene::Material& material,
                const glm::dmat4& world_from_mesh) {
  const glm::dmat3 normal_from_mesh = glm::transpose(glm::inverse(glm::dmat3(world_from_mesh)));
  out << "mesh2 {\nvertex_vectors { " << mesh.positions.size();
  for (const glm::vec3& position : mesh.positions) {
    out << ",\n" << pov_vector(glm::dvec3(world_from_mesh * glm::dvec4(position, 1.0)));
  }
  out << " }\nnormal_vectors { " << mesh.normals.size();
  for (const glm::vec3& normal : mesh.normals) {
    out << ",\n" << pov_vector(normal_from_mesh * glm::dvec3(normal));
  }
  out << " }\nface_indices { " << mesh.triangles.size();
  for (const glm::uvec3& t : mesh.triangles) {
    out << ",\n<" << t.x << ", " << t.y << ", " << t.z << ">";
  }
  out << " }\n" << pov_material(material) << "}\n";
}

}  // namespace

std::filesystem::path write_pov_scene(const BenchCase& bench_case,
                                      const trace::TraceSettings& settings,
                                      const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "scene.pov";
  std::ofstream out(path);
  const scene::Scene& scene = bench_case.scene;
  const scene::AnchoredScene anchored = scene::anchor_scene(scene, bench_case.input.poses);
  write_settings(out, settings);
  write_camera(out, bench_case.camera, anchored.camera_from_world);
  if (scene.environment) {
    write_environment(out, *scene.environment, folder);
    for (const auto& light : scene::extract_lights(*scene.environment, {})) write_light(out, light);
  }
  for (const scene::Light& light : anchored.punctual_lights) write_light(out, light);
  for (const scene::AnchoredInstance& placed : anchored.instances) {
    const scene::Instance& instance = scene.instances[placed.instance];
    write_mesh(out, scene.meshes[instance.mesh], scene.materials[instance.material],
               glm::dmat4(placed.world_from_mesh));
  }
  out.close();
  if (!out) throw std::runtime_error(path.string() + ": cannot be written");
  return path;
}

}  // namespace amalgam::bench
