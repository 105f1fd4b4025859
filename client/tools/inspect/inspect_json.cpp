#include <nlohmann/json.hpp>
#include <ostream>

#include "client/tools/inspect/inspect_report.h"
#include "scene/features.h"

namespace amalgam::tools {
namespace {

using Json = nlohmann::ordered_json;

Json rgb(const glm::vec3& c) {
  return Json::array({c.x, c.y, c.z});
}

Json material_json(const scene::Material& material) {
  Json json{{"name", material.name},
            {"kind", name_of(material.kind)},
            {"base_color",
             {material.base_color.x, material.base_color.y, material.base_color.z,
              material.base_color.w}},
            {"metallic", material.metallic},
            {"roughness", material.roughness},
            {"textured", material.base_color_texture.has_value()},
            {"double_sided", material.double_sided},
            {"emission", rgb(material.emission)}};
  if (material.alpha_cutoff) json["alpha_cutoff"] = *material.alpha_cutoff;
  if (material.kind == scene::MaterialKind::Dielectric) {
    json["ior"] = material.ior;
    json["thin"] = material.thin;
    json["absorption"] = rgb(material.absorption);
  }
  return json;
}

Json nodes_json(const scene::Scene& scene) {
  Json nodes = Json::array();
  for (const scene::Instance& instance : scene.instances) {
    nodes.push_back({{"node", instance.node},
                     {"role", name_of(instance.role)},
                     {"marker", instance.marker.value_or(scene.world.marker)},
                     {"triangles", scene.meshes[instance.mesh].triangles.size()},
                     {"material", instance.material}});
  }
  return nodes;
}

Json lights_json(const Inspection& inspection) {
  Json lights = Json::array();
  for (const scene::Light& light : inspection.environment_lights) {
    lights.push_back({{"source", "environment"},
                      {"kind", "directional"},
                      {"to_light", rgb(light.to_light)},
                      {"intensity", rgb(light.intensity)}});
  }
  for (const scene::PunctualLight& light : inspection.scene.punctual_lights) {
    lights.push_back({{"source", light.node},
                      {"kind", name_of(light.kind)},
                      {"marker", light.marker.value_or(inspection.scene.world.marker)},
                      {"intensity", rgb(light.intensity)}});
  }
  return lights;
}

}  // namespace

void print_json(std::ostream& out, const Inspection& inspection) {
  const scene::Scene& scene = inspection.scene;
  Json json;
  json["world"] = {{"marker", scene.world.marker},
                   {"dictionary", scene.world.dictionary},
                   {"marker_length", scene.world.marker_length}};
  std::size_t triangles = 0;
  for (const scene::Instance& instance : scene.instances) {
    triangles += scene.meshes[instance.mesh].triangles.size();
  }
  json["triangles"] = triangles;
  json["nodes"] = nodes_json(scene);
  json["materials"] = Json::array();
  for (const auto& material : scene.materials) json["materials"].push_back(material_json(material));
  json["environment"] = nullptr;
  if (const auto& environment = scene.environment) {
    json["environment"] = {{"width", environment->radiance.width()},
                           {"height", environment->radiance.height()},
                           {"low_dynamic_range", environment->low_dynamic_range}};
  }
  json["lights"] = lights_json(inspection);
  json["light_errors"] = Json::array();
  for (const auto& [choice, lights, error] : inspection.light_errors) {
    json["light_errors"].push_back({{"env_lights", choice},
                                    {"lights", lights},
                                    {"irradiance_rms", error.rms},
                                    {"irradiance_maximum", error.maximum}});
  }
  json["warnings"] = scene.warnings;
  json["notes"] = scene.notes;
  json["left_out"] = Json::array();
  for (const scene::Absence& absence : describe_absences(scene_features(scene))) {
    json["left_out"].push_back({{"what", absence.what}, {"reason", absence.reason}});
  }
  // Names come from files and need not be UTF-8.
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace amalgam::tools
