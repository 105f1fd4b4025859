// amalgam-inspect's report on a scene, for people and for programs.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "scene/light/env_lights.h"
#include "scene/light/irradiance.h"
#include "scene/scene.h"

namespace amalgam::tools {

struct Inspection {
  scene::Scene scene;
  std::vector<scene::Light> environment_lights;

  // The error of extracted lights against the environment's irradiance: of this run's choice, and
  // of the usual choices for comparison.
  struct LightError {
    std::string choice;  // as --env-lights takes it
    std::size_t lights = 0;
    scene::IrradianceError error;
  };
  std::vector<LightError> light_errors;
};

void print_text(std::ostream& out, const Inspection& inspection);

// One object: world, nodes, materials, triangles, environment, lights, light_errors (relative),
// warnings, notes, left_out.
void print_json(std::ostream& out, const Inspection& inspection);

const char* name_of(scene::Role role);
const char* name_of(scene::MaterialKind kind);
const char* name_of(scene::PunctualLight::Kind kind);

}  // namespace amalgam::tools
