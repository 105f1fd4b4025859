#include "scene/features.h"

#include <glm/vector_relational.hpp>

namespace amalgam::scene {

SceneFeatures scene_features(const Scene& scene) {
  SceneFeatures features;
  for (const Instance& instance : scene.instances) {
    const Material& material = scene.materials[instance.material];
    const bool real = instance.role == Role::Real, specular = is_specular(material.kind);
    (real ? features.has_real : features.has_virtual) = true;
    (specular ? features.has_specular : features.has_diffuse) = true;
    if (specular) (real ? features.has_real_specular : features.has_virtual_specular) = true;
    features.has_real_diffuse |= real && !specular;
    features.has_transmissive |= material.kind == MaterialKind::Dielectric;
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const TextureSlot slot : kAllTextureSlots)
      features.has_textures |= has_texture(material, mesh, slot);
    features.has_normal_textures |= has_texture(material, mesh, TextureSlot::Normal);
    features.has_vertex_colors |= !mesh.colors.empty();
    features.has_alpha_mask |= material.alpha_cutoff.has_value();
    features.has_emission |= material.emission != glm::vec3(0.0f);
  }
  features.has_environment = scene.environment.has_value();
  features.has_low_dynamic_range_environment =
      scene.environment && scene.environment->low_dynamic_range;
  features.has_punctual_lights = !scene.punctual_lights.empty();
  return features;
}

std::vector<Absence> describe_absences(const SceneFeatures& features) {
  std::vector<Absence> absences;
  const auto absent_unless = [&](bool present, const char* what, const char* reason) {
    if (!present) absences.push_back({what, reason});
  };
  absent_unless(features.has_virtual, "everything: the camera's JPEG goes back as it came",
                "nothing in the scene is virtual");
  absent_unless(features.has_specular, "Embree scene, trace, ray-tracing mask, real-only depth",
                "nothing in the scene is a mirror or transparent");
  if (features.has_specular) {
    absent_unless(features.has_transmissive, "refraction, colored shadow attenuation",
                  "nothing in the scene is transparent");
    absent_unless(features.has_real_specular, "difference part of the tracer",
                  "no real object is a mirror or transparent");
    absent_unless(features.has_low_dynamic_range_environment, "I_e buffer",
                  "the environment is not a low-dynamic-range map");
    absent_unless(features.has_real_diffuse, "camera look-ups", "no real object is diffuse");
  }
  absent_unless(features.has_diffuse, "diffuse pass, shadow maps",
                "nothing in the scene is diffuse");
  absent_unless(features.has_textures, "textures and their look-ups", "no material has a texture");
  absent_unless(features.has_normal_textures, "tangents, bent normals",
                "no material has a normal texture");
  absent_unless(features.has_vertex_colors, "vertex colors", "no mesh has any");
  absent_unless(features.has_alpha_mask, "alpha test", "no material is masked");
  absent_unless(features.has_emission, "emission", "nothing in the scene glows");
  absent_unless(features.has_environment, "environment look-ups, light extraction",
                "the scene names no environment");
  absent_unless(features.has_punctual_lights, "point, spot and directional lights of the scene",
                "the scene has none");
  return absences;
}

}  // namespace amalgam::scene
