#include "trace/first_hits.h"

#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>
#include <limits>

#include "common/pose.h"
#include "core/tile_grid.h"

namespace amalgam::trace {

FirstHits find_first_hits(const EmbreeScene& scene, const common::CameraModel& camera,
                          const glm::dmat4& camera_from_world, std::span<const std::size_t> tiles) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  FirstHits hits{common::Image<std::uint32_t>(camera.width, camera.height, FirstHits::kNothing),
                 common::Image32f(camera.width, camera.height, kInfinity)};
  const glm::dmat4 world_from_camera = common::rigid_inverse(camera_from_world);
  const glm::dmat3 rotation(world_from_camera);
  const glm::vec3 origin(world_from_camera[3]);
  const core::TileGrid grid({camera.width, camera.height});
  tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) {
    const glm::ivec2 first = grid.first_pixel(tiles[i]), end = grid.end_pixel(tiles[i]);
    for (int y = first.y; y < end.y; ++y) {
      for (int x = first.x; x < end.x; ++x) {
        const glm::dvec3 direction = rotation * *common::pixel_direction(camera, {x, y});
        const auto hit = scene.intersect({origin, glm::vec3(glm::normalize(direction)), kInfinity},
                                         Visible::Everything);
        if (!hit) continue;
        hits.instance.at(x, y) = hit->instance;
        hits.distance.at(x, y) = static_cast<float>(hit->t);
      }
    }
  });
  return hits;
}

}  // namespace amalgam::trace
