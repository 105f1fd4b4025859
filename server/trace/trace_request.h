// Input and output of the tracer.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/camera_model.h"
#include "common/image.h"
#include "core/layers.h"
#include "core/progress.h"
#include "core/provenance.h"
#include "core/ray_counts.h"
#include "core/truncation.h"
#include "scene/light/environment.h"
#include "scene/light/light.h"
#include "scene/light/real_surfaces.h"
#include "trace/camera_lookup.h"
#include "trace/embree_scene.h"
#include "trace/fresnel.h"
#include "trace/ray_log.h"
#include "trace/shadow_bound.h"
#include "trace/traced_paths.h"

namespace amalgam::trace {

struct TraceSettings {
  int max_depth = 10;  // specular surfaces that a ray may meet
  // Importance below which a branch ends. The default is the largest with a mean difference to the
  // reference below 0.5/255 on each scene.
  float importance_cutoff = 0.05f;
  FresnelModel fresnel = FresnelModel::Schlick;
  bool operator==(const TraceSettings&) const = default;
};

struct TraceRequest {
  const EmbreeScene& scene;
  std::span<const scene::Light> lights;
  const scene::Environment* environment = nullptr;  // null: black
  // scene::largest_radiance(*environment), for the truncation bound. None: found by each call.
  std::optional<glm::vec3> largest_environment{};
  common::CameraModel camera;  // pinhole; primary rays go through its pixels
  glm::dmat4 camera_from_world{1.0};
  // n: sample (i, j) of pixel (x, y) lies at x - 0.5 + (i + 0.5) / n, y likewise.
  int samples_per_side = 1;

  // Size camera * n. Samples with (value & mask_bit) != 0 are traced. Null: all are.
  const common::Image<std::uint8_t>* mask = nullptr;
  std::uint8_t mask_bit = 0;

  // Null: every shadow ray is traced.
  const ShadowBound* virtual_shadows = nullptr;

  // Null: no look-ups, real surfaces are shaded as modelled.
  const CameraView* lookup = nullptr;
  // Set if lookup is; of its camera's size.
  const common::ImageRgb8* camera_image = nullptr;
  scene::ToneMap tone_map{};
  scene::RealSurfaces real_surfaces = scene::RealSurfaces::Ratio;
  // Diffuse surfaces are shaded as if they were white Lambertian ones without emission: their
  // radiance is then irradiance / pi.
  bool white_surfaces = false;
  TraceSettings settings{};
  bool keep_images = false;
  bool keep_provenance = false;
  // Bytes. Paths are kept if they take less memory than this; 0: never.
  std::size_t keep_paths_below = 0;
  RayLog* ray_log = nullptr;           // filled if given
  core::Progress* progress = nullptr;  // stepped at each tile, which may cancel the frame
};

// The thesis's buffers, from the first sample of each traced pixel; 0 elsewhere.
struct TracedImages {
  common::ImageRgb32f mixed;  // I_m, scene-linear
  // I_r, scene-linear; alpha 1 where the primary ray meets a real diffuse surface.
  common::ImageRgba32f real;
  common::ImageRgb32f environment_reflection;  // I_e, display-linear
  common::Image<std::uint8_t> met_virtual;     // M_v
};

struct TraceResult {
  core::Layers layers;  // of the traced samples; the rasteriser adds the others
  PathCounts counts;
  std::uint64_t nonfinite = 0;  // sample values replaced by 0
  // Of the traced samples (truncation_bound.h).
  core::TruncationBound truncation;
  std::shared_ptr<const TracedPaths> paths;  // null: not kept
  std::optional<TracedImages> images;
  std::optional<core::ProvenanceImage> provenance;  // of the traced samples
};

}  // namespace amalgam::trace
