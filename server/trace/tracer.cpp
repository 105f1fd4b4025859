#include "trace/tracer.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <limits>
#include <vector>

#include "common/log.h"
#include "common/pose.h"
#include "trace/add_look_ups.h"
#include "trace/media_at.h"
#include "trace/resolve_tile.h"
#include "trace/tile.h"

namespace amalgam::trace {
namespace {

TraceResult empty_result(const TraceRequest& request) {
  const int width = request.camera.width, height = request.camera.height;
  TraceResult result;
  result.layers = core::Layers({width, height});
  if (request.keep_images) {
    result.images = TracedImages{
        common::ImageRgb32f(width, height), common::ImageRgba32f(width, height),
        common::ImageRgb32f(width, height), common::Image<std::uint8_t>(width, height)};
  }
  if (request.keep_provenance) result.provenance.emplace(width, height);
  return result;
}

// Collects the tiles' paths up to the memory limit.
class PathKeeper {
 public:
  PathKeeper(const TraceRequest& request, const RadianceLimit& limit, std::size_t tiles)
      : most_bytes_(request.keep_paths_below) {
    if (most_bytes_ == 0) return;
    paths_ = std::make_shared<TracedPaths>();
    paths_->size = {request.camera.width, request.camera.height};
    paths_->samples_per_side = request.samples_per_side;
    paths_->limit = limit;
    paths_->tiles.resize(tiles);
  }

  // Different tiles may be kept by different threads.
  void keep(std::size_t tile, const TilePaths& paths) {
    if (paths_ == nullptr || paths.samples.empty()) return;
    if (bytes_ += paths.bytes(); bytes_ < most_bytes_) paths_->tiles[tile] = paths;
  }

  // Null if they exceeded it.
  std::shared_ptr<const TracedPaths> take(const PathCounts& counts) {
    if (paths_ == nullptr || bytes_ >= most_bytes_) return nullptr;
    paths_->counts = counts;
    return std::move(paths_);
  }

 private:
  std::size_t most_bytes_;
  std::shared_ptr<TracedPaths> paths_;
  std::atomic<std::size_t> bytes_ = 0;
};

RadianceLimit radiance_limit(const TraceRequest& request) {
  const scene::Environment* environment = request.environment;
  glm::vec3 largest(0.0f);
  if (environment != nullptr) {
    largest = request.largest_environment ? *request.largest_environment
                                          : scene::largest_radiance(*environment);
  }
  return find_radiance_limit(request.scene, request.lights, environment, largest,
                             request.lookup != nullptr);
}

// In the order of the tiles, so that sums do not depend on the threads.
void add_resolved(const std::vector<ResolvedTile>& tiles, TraceResult& result) {
  ResolvedTile all;
  for (const ResolvedTile& tile : tiles) all += tile;
  result.nonfinite = all.nonfinite;
  result.truncation = all.truncation;
}

}  // namespace

TraceResult trace(const TraceRequest& request) {
  constexpr int kMostPixels = std::numeric_limits<std::uint16_t>::max();
  AMALGAM_CHECK(request.camera.width <= kMostPixels && request.camera.height <= kMostPixels,
                "a picture of more than 65535 pixels a side");
  TraceResult result = empty_result(request);
  std::optional<CameraLookup> lookup;
  if (request.lookup != nullptr) lookup.emplace(*request.lookup);
  const glm::dmat4 world_from_camera = common::rigid_inverse(request.camera_from_world);
  const TileContext context{request, lookup ? &*lookup : nullptr,
                            media_at(request.scene, glm::vec3(world_from_camera[3])),
                            world_from_camera};

  const std::size_t tiles = result.layers.grid().count();
  std::vector<PathCounts> counts(tiles);
  std::vector<ResolvedTile> resolved(tiles);
  std::vector<std::vector<LoggedRay>> logged(request.ray_log != nullptr ? tiles : 0);
  const RadianceLimit limit = radiance_limit(request);
  const RadianceLimit limit_with_camera =
      lookup ? with_camera_image(limit, *request.camera_image, request.tone_map) : limit;
  PathKeeper keeper(request, limit, tiles);
  tbb::enumerable_thread_specific<Tile> workers([&] { return Tile(context); });
  tbb::parallel_for(std::size_t{0}, tiles, [&](std::size_t i) {
    if (request.progress != nullptr) request.progress->step();
    Tile& tile = workers.local();
    tile.start(i);
    tile.trace();
    keeper.keep(i, tile.paths());
    if (lookup) {
      add_look_ups(tile.paths(), *request.camera_image, request.tone_map, request.real_surfaces);
    }
    resolved[i] = resolve_tile(i, tile.paths(), limit_with_camera, request.samples_per_side,
                               request.tone_map, request.real_surfaces, result);
    if (result.provenance) tile.keep_provenance(*result.provenance);
    counts[i] = tile.counts();
    if (request.ray_log != nullptr) logged[i] = tile.logged();
  });
  for (const PathCounts& tile : counts) result.counts += tile;
  add_resolved(resolved, result);
  for (const auto& rays : logged) {
    request.ray_log->rays.insert(request.ray_log->rays.end(), rays.begin(), rays.end());
  }
  result.paths = keeper.take(result.counts);
  return result;
}

TraceResult look_up_again(const TracedPaths& paths, const common::ImageRgb8& camera_image,
                          const scene::ToneMap& tone_map, scene::RealSurfaces real_surfaces) {
  TraceResult result;
  result.layers = core::Layers(paths.size);
  result.counts = paths.counts;
  result.counts.rays = {.reused = paths.counts.rays.cast()};
  const RadianceLimit limit = with_camera_image(paths.limit, camera_image, tone_map);
  std::vector<ResolvedTile> resolved(paths.tiles.size());
  tbb::enumerable_thread_specific<TilePaths> workers;
  tbb::parallel_for(std::size_t{0}, paths.tiles.size(), [&](std::size_t i) {
    if (paths.tiles[i].samples.empty()) return;
    TilePaths& tile = workers.local();
    tile = paths.tiles[i];
    add_look_ups(tile, camera_image, tone_map, real_surfaces);
    resolved[i] =
        resolve_tile(i, tile, limit, paths.samples_per_side, tone_map, real_surfaces, result);
  });
  add_resolved(resolved, result);
  return result;
}

}  // namespace amalgam::trace
