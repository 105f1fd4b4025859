// What amalgam-inspect says about a scene, for people and for programs.
#pragma once

#include <iosfwd>
#include <vector>

#include "scene/env_lights.h"
#include "scene/scene.h"

namespace amalgam::tools {

struct Inspection {
  scene::Scene scene;
  std::vector<scene::Light> environment_lights;
};

void print_text(std::ostream& out, const Inspection& inspection);

// One object: world, nodes, materials, environment, lights, notes, left_out.
void print_json(std::ostream& out, const Inspection& inspection);

const char* name_of(scene::Role role);
const char* name_of(scene::MaterialKind kind);
const char* name_of(scene::PunctualLight::Kind kind);

}  // namespace amalgam::tools
