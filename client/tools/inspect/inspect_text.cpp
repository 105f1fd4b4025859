#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <ostream>
#include <string>

#include "client/tools/inspect/inspect_report.h"
#include "scene/features.h"

namespace amalgam::tools {
namespace {

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

std::string format_rgb(const glm::vec3& c) {
  return format("%.3g %.3g %.3g", static_cast<double>(c.x), static_cast<double>(c.y),
                static_cast<double>(c.z));
}

std::string describe(const scene::Material& material) {
  std::string text = material.name + ": " + name_of(material.kind);
  const auto color = glm::vec3(material.base_color);
  switch (material.kind) {
    case scene::MaterialKind::Mirror:
      return text + ", F0 " + format_rgb(color);
    case scene::MaterialKind::Dielectric:
      text += format(", ior %.4g", static_cast<double>(material.ior));
      if (material.thin) return text + ", thin (rays pass undeviated)";
      return text + ", solid, absorption " + format_rgb(material.absorption) + " 1/m";
    case scene::MaterialKind::Diffuse:
      break;
  }
  text += ", color " + format_rgb(color) +
          format(", Phong exponent %.3g",
                 static_cast<double>(scene::phong_terms(material, color).exponent));
  if (material.base_color_texture) text += ", textured";
  if (material.alpha_cutoff)
    text += format(", masked at %.3g", static_cast<double>(*material.alpha_cutoff));
  if (material.emission != glm::vec3(0.0f)) text += ", emits " + format_rgb(material.emission);
  return text;
}

void print_nodes(std::ostream& out, const scene::Scene& scene) {
  std::size_t total = 0;
  out << "nodes:\n";
  for (const scene::Instance& instance : scene.instances) {
    const std::size_t triangles = scene.meshes[instance.mesh].triangles.size();
    total += triangles;
    out << format("  %-20s %-8s marker %-6s %7zu triangles  ", instance.node.c_str(),
                  name_of(instance.role),
                  std::to_string(instance.marker.value_or(scene.world.marker)).c_str(), triangles)
        << describe(scene.materials[instance.material]) << '\n';
  }
  out << "  " << total << " triangles in all\n";
}

void print_lights(std::ostream& out, const Inspection& inspection) {
  if (const auto& environment = inspection.scene.environment) {
    out << "environment: " << environment->radiance.width() << "x" << environment->radiance.height()
        << (environment->low_dynamic_range ? " low" : " high") << " dynamic range\n";
  } else {
    out << "environment: none\n";
  }
  out << "lights:\n";
  for (const scene::Light& light : inspection.environment_lights) {
    out << "  from the environment, towards " << format_rgb(light.to_light) << ", irradiance "
        << format_rgb(light.intensity) << '\n';
  }
  for (const auto& [choice, lights, error] : inspection.light_errors) {
    out << "  " << choice << ": " << lights << " lights, irradiance off by "
        << static_cast<double>(std::lround(error.rms * 1e4)) / 100.0 << " % rms, "
        << static_cast<double>(std::lround(error.maximum * 1e4)) / 100.0 << " % at most\n";
  }
  for (const scene::PunctualLight& light : inspection.scene.punctual_lights) {
    const bool directional = light.kind == scene::PunctualLight::Kind::Directional;
    out << "  " << light.node << ": " << name_of(light.kind) << ", "
        << (directional ? "irradiance " : "radiant intensity ") << format_rgb(light.intensity)
        << '\n';
  }
}

}  // namespace

const char* name_of(scene::Role role) {
  return role == scene::Role::Real ? "real" : "virtual";
}

const char* name_of(scene::MaterialKind kind) {
  switch (kind) {
    case scene::MaterialKind::Diffuse:
      return "diffuse";
    case scene::MaterialKind::Mirror:
      return "mirror";
    case scene::MaterialKind::Dielectric:
      break;
  }
  return "dielectric";
}

const char* name_of(scene::PunctualLight::Kind kind) {
  switch (kind) {
    case scene::PunctualLight::Kind::Directional:
      return "directional";
    case scene::PunctualLight::Kind::Point:
      return "point";
    case scene::PunctualLight::Kind::Spot:
      break;
  }
  return "spot";
}

void print_text(std::ostream& out, const Inspection& inspection) {
  const scene::Scene& scene = inspection.scene;
  out << "world: marker " << scene.world.marker << " of " << scene.world.dictionary << ", "
      << scene.world.marker_length << " m\n";
  print_nodes(out, scene);
  print_lights(out, inspection);
  if (!scene.warnings.empty()) out << "warnings:\n";
  for (const std::string& warning : scene.warnings) out << "  " << warning << '\n';
  out << "notes:" << (scene.notes.empty() ? " none\n" : "\n");
  for (const std::string& note : scene.notes) out << "  " << note << '\n';
  out << "left out in every frame:\n";
  for (const scene::Absence& absence : describe_absences(scene_features(scene))) {
    out << "  " << absence.what << ": " << absence.reason << '\n';
  }
}

}  // namespace amalgam::tools
