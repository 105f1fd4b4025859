// Table 6.1 of the thesis: frames a second of its two systems. Its PC 1 is the one that ours is
// compared with.
#pragma once

#include <span>

namespace amalgam::bench {

enum class ThesisScene { GlassBunny, MirrorBunny, Complex };

enum class ThesisMethod {
  Rasterizer,             // that of the RESHADE framework: specular objects approximated
  RasterizerSecondOrder,  // note 1: including second order reflections
  OurMethod,              // hybrid
  RayTracer,              // note 2: for the whole image
  DiffuseObjects,         // note 3: specular objects were replaced with diffuse ones
};

struct ThesisRow {
  ThesisScene scene = ThesisScene::GlassBunny;
  int samples = 1;  // "no AA", 4x SSAA, 9x SSAA
  int width = 0, height = 0;
  int pc = 1;
  ThesisMethod method = ThesisMethod::OurMethod;
  double frames_per_second = 0.0;
  const char* image = "";  // in the thesis's appendix
};

// In the thesis's order.
std::span<const ThesisRow> thesis_table();

// Whether Amalgam has the same method and the row is one of PC 1: then it is held to the goal.
// Other rows are compared with the hybrid renderer, for information.
bool is_held_to_goal(const ThesisRow& row);

const char* to_string(ThesisScene scene);
const char* to_string(ThesisMethod method);

}  // namespace amalgam::bench
