#include "trace/tracer.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <vector>

#include "core/pose.h"
#include "trace/media_at.h"
#include "trace/tile.h"

namespace amalgam::trace {
namespace {

TraceResult empty_result(const TraceRequest& request) {
  const int width = request.camera.width, height = request.camera.height;
  TraceResult result;
  result.layers = core::Layers({width, height});
  if (request.keep_images) {
    result.images =
        TracedImages{core::ImageRgb32f(width, height), core::ImageRgba32f(width, height),
                     core::ImageRgb32f(width, height), core::Image<std::uint8_t>(width, height)};
  }
  if (request.keep_provenance) result.provenance.emplace(width, height);
  return result;
}

void add(TraceResult& result, const TileCounts& tile) {
  result.rays += tile.rays;
  result.nonfinite += tile.nonfinite;
  result.traced_samples += tile.samples;
  result.primary_virtual += tile.primary_virtual;
  result.primary_specular += tile.primary_specular;
}

}  // namespace

TraceResult trace(const TraceRequest& request) {
  TraceResult result = empty_result(request);
  std::optional<CameraLookup> lookup;
  if (request.lookup != nullptr) lookup.emplace(*request.lookup);
  const glm::dmat4 world_from_camera = core::rigid_inverse(request.camera_from_world);
  const TileContext context{request, lookup ? &*lookup : nullptr,
                            media_at(request.scene, glm::vec3(world_from_camera[3])),
                            world_from_camera};

  const std::size_t tiles = result.layers.grid().count();
  std::vector<TileCounts> counts(tiles);
  std::vector<std::vector<LoggedRay>> logged(request.ray_log != nullptr ? tiles : 0);
  tbb::enumerable_thread_specific<Tile> workers([&] { return Tile(context); });
  tbb::parallel_for(std::size_t{0}, tiles, [&](std::size_t i) {
    Tile& tile = workers.local();
    tile.start(i);
    tile.trace();
    tile.resolve(result);
    counts[i] = tile.counts();
    if (request.ray_log != nullptr) logged[i] = tile.logged();
  });
  for (const TileCounts& tile : counts) add(result, tile);
  for (const auto& rays : logged) {
    request.ray_log->rays.insert(request.ray_log->rays.end(), rays.begin(), rays.end());
  }
  return result;
}

}  // namespace amalgam::trace
