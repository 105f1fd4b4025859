// The independent second renderer that the fast one is held against: double precision, scalar,
// recursive, its own intersections, written from the equations. It shares data types with the
// server and no code that computes a color or meets a surface.
#pragma once

#include <cstdint>
#include <vector>

#include "common/camera_model.h"
#include "common/image.h"
#include "scene/anchored_scene.h"
#include "scene/light/light.h"
#include "scene/scene.h"
#include "support/reference/composite.h"
#include "support/reference/whitted.h"

namespace amalgam::reference {

// Whether a pixel's value is one that arithmetic in float can be held to. Asked by turning its
// primary ray by 2^-22 (times the focal length: about 1e-4 of a pixel) in each diagonal direction,
// which is what a few roundings to float may do to a hit point.
enum class Grazing : std::uint8_t {
  No,
  Steep,  // the color changes by more than kSteep: tangents of curved glass and mirrors
  Edge,   // something else is decided on the way (decisions.h): what is met, what is cut off
};
constexpr double kSteep = 2e-3;  // relative_error.h

// A rasteriser puts corners on a grid of 256 a pixel (OpenGL asks for 16 at least, drivers have
// 256): what lies first under a sample is sure only where it is the same this far around.
constexpr double kRasterGrid = 1.0 / 256.0;  // sample spacings

struct ReferenceRequest {
  common::CameraModel camera;  // as the client has it, with distortion
  scene::AnchoredScene anchored;
  std::vector<scene::Light> lights;                 // world frame, environment lights included
  const common::ImageRgb8* camera_image = nullptr;  // size of the camera; required
  Response response;                                // the camera's
  int samples_per_side = 1;
  TraceSettings settings;
  bool find_grazing = false;  // and rims; costs four more renderings
};

// Geometry of the ideal camera except where said. The images of the thesis hold the first sample
// of each pixel.
struct ReferenceImages {
  common::Image<Color> mixed;                   // I_m
  common::Image<Color> real;                    // I_r
  common::Image<Color> environment_reflection;  // I_e
  common::Image<std::uint8_t> virtual_mask;     // M_v
  common::Image<std::uint8_t> specular_mask;    // M_r
  common::Image<std::uint8_t> grazing;          // a Grazing, the largest of the pixel's samples
  common::Image<std::uint8_t> rim;  // 1: one of its samples lies at a rim, see kRasterGrid
  Layers layers;
  common::ImageRgb8 composite;  // the camera's own geometry
};

ReferenceImages render_reference(const scene::Scene& scene, const ReferenceRequest& request);

// The same for a world made otherwise.
ReferenceImages render_reference(const World& world, const scene::Environment* environment,
                                 const ReferenceRequest& request);

}  // namespace amalgam::reference
