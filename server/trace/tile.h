// One tile of a traced frame: its samples, its queues and the verbs that work on them.
#pragma once

#include <vector>

#include "core/tile_grid.h"
#include "trace/trace_request.h"
#include "trace/traced_paths.h"
#include "trace/work_items.h"

namespace amalgam::trace {

// Input that all tiles of a frame share.
struct TileContext {
  const TraceRequest& request;
  const CameraLookup* lookup = nullptr;  // null: no look-ups, real surfaces are shaded as modelled
  Media camera_media;                    // those around the camera
  glm::dmat4 world_from_camera{1.0};
};

// Each verb has its own file; tile.cpp says their order. A thread uses one object for all its
// tiles, so that queues are allocated once.
class Tile {
 public:
  explicit Tile(const TileContext& context);

  // Starts another tile of the picture.
  void start(std::size_t tile);

  // Traces the tile's samples to the end: the list of verbs.
  void trace();

  // The result without the camera's colors, which the caller may add in place (add_look_ups.h).
  TilePaths& paths() { return paths_; }
  const PathCounts& counts() const { return counts_; }
  // Adds the samples' provenance to their pixels, if the request keeps it.
  void keep_provenance(core::ProvenanceImage& image) const;
  const std::vector<LoggedRay>& logged() const { return logged_; }

 private:
  void generate_primary_rays();
  void take_batch();
  void intersect_rays();
  void shade_hits();
  void add_escaped();
  void find_in_camera();
  void spawn_shadow_rays();
  void trace_shadow_rays();
  void add_diffuse();

  DiffuseRadiance emitted(const DiffuseItem& item) const;
  void spawn_shadow_rays(std::uint32_t diffuse, const ShadowBound* bound);
  ShadowAttenuation trace_shadow_ray(const ShadowItem& shadow, bool only_change);
  void add_light(const ShadowItem& shadow, const ShadowAttenuation& attenuation);
  void shade_changed_in_full();
  void add_sample(const glm::ivec2& pixel, const glm::dvec2& at, bool first_of_pixel);
  void count_primary(const SurfacePoint& point, const scene::Material& material);
  void scatter(const RayItem& item, const MetSurface& met);
  void scatter_mirror(const RayItem& item, const MetSurface& met, const glm::dvec3& normal);
  void scatter_thin(const RayItem& item, const MetSurface& met, const glm::dvec3& normal);
  void scatter_solid(const RayItem& item, const MetSurface& met, const glm::dvec3& normal);
  void scatter_back(const RayItem& item, const MetSurface& met, float k_s);
  void continue_through_cutout(const RayItem& item, const SurfacePoint& point);
  void spawn(const RayItem& parent, const MetSurface& met, const glm::dvec3& direction,
             const glm::vec3& weight, RayKind kind, const Media& media);
  // The weight of a light's radiance in a medium, from the weight of a ray. Across an interface
  // L / n^2 is conserved: the same light fills a narrower cone within the denser medium. So rays
  // keep their weights, and only the ends of a path count: a surface within water is n^2 darker
  // from outside than from within, and what lies outside is n^2 brighter from within.
  glm::vec3 light_weight(const glm::vec3& ray_weight, const Media& media) const;
  void add_provenance(std::uint32_t sample, core::LightSource source, float share);
  void log(const Ray& ray, Visible visible, RayQuery query);

  const scene::Material& material(std::uint32_t index) const {
    return request_.scene.scene().materials[index];
  }

  const TileContext& context_;
  const TraceRequest& request_;
  core::TileGrid grid_;
  double sample_spread_;  // angle between neighbouring samples, radians: the spread of ray cones
  std::size_t tile_ = 0;

  TilePaths paths_;
  std::vector<core::Provenance> provenance_;  // by sample, if kept: shares of its light

  // A stack: batches come from its end, so that the depth bounds its size.
  std::vector<RayItem> waiting_;
  std::vector<RayItem> batch_;
  std::vector<std::optional<Hit>> hits_;
  std::vector<EscapedItem> escaped_;
  std::vector<DiffuseItem> diffuse_;
  std::vector<DiffuseRadiance> radiance_;  // by diffuse_
  std::vector<ShadowItem> shadows_;
  std::vector<std::uint8_t> changed_;  // by diffuse_: 1 if only_change_counts() and light changes
  PassedSurfaces passed_;
  std::vector<LoggedRay> logged_;
  PathCounts counts_;
};

}  // namespace amalgam::trace
