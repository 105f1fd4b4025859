// One tile of a traced frame: its samples, its queues and the verbs that work on them.
#pragma once

#include <vector>

#include "core/tile_grid.h"
#include "trace/tracer.h"
#include "trace/work_items.h"

namespace amalgam::trace {

// What a tile adds to the TraceResult of the same names.
struct TileCounts {
  core::RayCounts rays;
  std::uint64_t nonfinite = 0, samples = 0, primary_virtual = 0, primary_specular = 0;
};

class Tile {
 public:
  // The pixels [x, x + side) x [y, y + side) of the request's camera that lie inside it.
  // camera_media: what the camera stands in.
  Tile(const TraceRequest& request, const CameraLookup* lookup, const Media& camera_media, int x,
       int y);

  // The whole way of the tile's samples, as a list of verbs.
  void trace();

  // Adds the finished samples to the pixels they belong to. Tiles share no pixel.
  void resolve(TraceResult& result);

  const TileCounts& counts() const { return counts_; }

 private:
  struct SamplePlace {
    int pixel_x = 0, pixel_y = 0;
    bool first_of_pixel = false;
  };

  void generate_primary_rays();
  void take_batch();
  void intersect_rays();
  void shade_hits();
  void add_escaped();
  void spawn_shadow_rays();
  void trace_shadow_rays();
  void add_diffuse();

  void count_primary(const SurfacePoint& point, const scene::Material& material);
  void scatter(const RayItem& item, const SurfacePoint& point, const glm::vec3& weight);
  void scatter_back(const RayItem& item, const SurfacePoint& point, const glm::vec3& weight);
  void pass_straight(const RayItem& item, const SurfacePoint& point);
  void spawn(const RayItem& parent, const SurfacePoint& point, const glm::dvec3& direction,
             const glm::vec3& weight, RayKind kind, const Media& media);
  void add_real_surface(const DiffuseItem& item, const DiffuseRadiance& radiance);

  const TraceRequest& request_;
  const CameraLookup* lookup_;
  Media camera_media_;
  int x_, y_;

  std::vector<SamplePlace> places_;
  std::vector<SampleResult> samples_;
  std::vector<bool> sees_real_diffuse_;

  std::vector<RayItem>
      waiting_;  // a stack: batches are taken from its end, which bounds its size by the depth
  std::vector<RayItem> batch_;
  std::vector<std::optional<Hit>> hits_;
  std::vector<EscapedItem> escaped_;
  std::vector<DiffuseItem> diffuse_;
  std::vector<DiffuseRadiance> radiance_;  // by diffuse_
  std::vector<ShadowItem> shadows_;
  TileCounts counts_;
};

}  // namespace amalgam::trace
