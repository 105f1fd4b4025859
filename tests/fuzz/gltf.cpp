// A scene file: refused with SceneError, or a scene as scene.h promises it.
#include <cmath>
#include <glm/geometric.hpp>

#include "common/log.h"
#include "fuzz/scratch_file.h"
#include "fuzz/target.h"
#include "scene/gltf/loader.h"

namespace amalgam::fuzz {
namespace {

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check(const scene::Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  AMALGAM_CHECK(mesh.normals.size() == count, mesh.name);
  AMALGAM_CHECK(mesh.uvs.empty() || mesh.uvs.size() == count, mesh.name);
  AMALGAM_CHECK(mesh.second_uvs.empty() || mesh.second_uvs.size() == count, mesh.name);
  AMALGAM_CHECK(mesh.colors.empty() || mesh.colors.size() == count, mesh.name);
  AMALGAM_CHECK(mesh.tangents.empty() || mesh.tangents.size() == count, mesh.name);
  for (const glm::vec3& position : mesh.positions) AMALGAM_CHECK(is_finite(position), mesh.name);
  for (const glm::vec3& normal : mesh.normals) {
    AMALGAM_CHECK(std::abs(glm::length(normal) - 1.0f) < 1e-3f,
                  mesh.name + ": a normal of length " + std::to_string(glm::length(normal)));
  }
  for (const glm::uvec3& corners : mesh.triangles) {
    AMALGAM_CHECK(corners.x < count && corners.y < count && corners.z < count, mesh.name);
  }
}

void check(const scene::Scene& scene) {
  for (const scene::Mesh& mesh : scene.meshes) check(mesh);
  for (const scene::Instance& instance : scene.instances) {
    AMALGAM_CHECK(instance.mesh < scene.meshes.size(), instance.node);
    AMALGAM_CHECK(instance.material < scene.materials.size(), instance.node);
    for (int column = 0; column < 4; ++column) {
      AMALGAM_CHECK(is_finite(instance.anchor_from_mesh[column]), instance.node);
    }
  }
  for (const scene::PunctualLight& light : scene.punctual_lights) {
    AMALGAM_CHECK(is_finite(light.intensity), light.node);
    for (int column = 0; column < 4; ++column) {
      AMALGAM_CHECK(is_finite(light.anchor_from_light[column]), light.node);
    }
  }
  for (const scene::Material& material : scene.materials) {
    AMALGAM_CHECK(is_finite(material.emission), material.name);
    AMALGAM_CHECK(is_finite(material.absorption), material.name);
    AMALGAM_CHECK(std::isfinite(material.normal_scale), material.name);
  }
}

}  // namespace
}  // namespace amalgam::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amalgam;
  static const fuzz::ScratchFile file("scene.gltf");  // a GLB is known by its first bytes
  file.write(fuzz::as_text(data, size));
  try {
    fuzz::check(scene::load_scene(file.path()));
  } catch (const scene::SceneError&) {
  }
  return 0;
}
