// The independent second renderer that the fast one is held against: double precision, scalar,
// recursive, its own intersections, written from the equations. It shares data types with the
// server and no code that computes a colour or meets a surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/camera_model.h"
#include "core/image.h"
#include "scene/anchored_scene.h"
#include "scene/light.h"
#include "scene/scene.h"
#include "support/reference/composite.h"
#include "support/reference/whitted.h"

namespace amalgam::reference {

struct ReferenceRequest {
  core::CameraModel camera;  // as the client has it, with distortion
  scene::AnchoredScene anchored;
  std::vector<scene::Light> lights;               // world frame, environment lights included
  const core::ImageRgb8* camera_image = nullptr;  // size of the camera; required
  double exposure = 1.0;
  int samples_per_side = 1;
  TraceSettings settings;
  bool find_grazing = false;  // costs five more renderings
};

// Geometry of the ideal camera except where said. The images of the thesis hold the first sample
// of each pixel.
struct ReferenceImages {
  core::Image<Color> mixed;                   // I_m
  core::Image<Color> real;                    // I_r
  core::Image<Color> environment_reflection;  // I_e
  core::Image<std::uint8_t> virtual_mask;     // M_v
  core::Image<std::uint8_t> specular_mask;    // M_r
  // 1 where some sample grazes an edge: nudging its rays changes a decision of their tree
  // (decisions.h). The nudges: each primary ray by 1e-4 of a pixel in each diagonal direction, and
  // every other ray's start by 1/65536 m off its surface, the renderer's stated resolution limit
  // near the origin (numerics B1, B2).
  core::Image<std::uint8_t> grazing;
  Layers layers;
  core::ImageRgb8 composite;  // the camera's own geometry
};

ReferenceImages render_reference(const scene::Scene& scene, const ReferenceRequest& request);

// The same for a world made otherwise.
ReferenceImages render_reference(const World& world, const scene::Environment* environment,
                                 const ReferenceRequest& request);

}  // namespace amalgam::reference
