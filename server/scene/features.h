// The features of a scene that decide what a frame needs (design, "Leave out what a given scene
// does not need").
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace amalgam::scene {

struct SceneFeatures {
  bool has_virtual = false;   // anything to add to the picture
  bool has_real = false;      // models of real objects, to shade, shadow and reflect
  bool has_specular = false;  // mirrors or dielectrics: something to trace
  bool has_real_specular = false;
  bool has_virtual_specular = false;
  bool has_transmissive = false;  // dielectrics: refraction, colored shadows
  bool has_diffuse = false;
  bool has_real_diffuse = false;  // real surfaces for look-ups
  bool has_textures = false;      // used by a material that is used
  bool has_normal_textures = false;
  bool has_vertex_colors = false;
  bool has_alpha_mask = false;
  bool has_emission = false;
  bool has_environment = false;
  bool has_low_dynamic_range_environment = false;  // I_e exists
  bool has_punctual_lights = false;

  bool operator==(const SceneFeatures&) const = default;
};

SceneFeatures scene_features(const Scene& scene);

// Work that frames of this scene never need, and why.
struct Absence {
  std::string what;    // "diffuse pass, shadow maps"
  std::string reason;  // "nothing in the scene is diffuse"
};
std::vector<Absence> describe_absences(const SceneFeatures& features);

}  // namespace amalgam::scene
