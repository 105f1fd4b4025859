// Verb: a ray through each sample of the tile that is to be traced.
#include <glm/geometric.hpp>
#include <limits>

#include "trace/tile.h"

namespace amalgam::trace {

void Tile::generate_primary_rays() {
  const int n = request_.samples_per_side;
  const glm::ivec2 first = grid_.first_pixel(tile_), end = grid_.end_pixel(tile_);
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      bool first_of_pixel = true;
      for (int s = 0; s < n * n; ++s) {
        const int i = s % n, j = s / n;
        if (request_.mask != nullptr &&
            (request_.mask->at(x * n + i, y * n + j) & request_.mask_bit) == 0) {
          continue;
        }
        add_sample({x, y}, {x - 0.5 + (i + 0.5) / n, y - 0.5 + (j + 0.5) / n}, first_of_pixel);
        first_of_pixel = false;
      }
    }
  }
  counts_.samples = paths_.samples.size();
  std::reverse(waiting_.begin(), waiting_.end());
}

// The direction comes from the intrinsics in double (numerics B14). A pinhole camera has one for
// every pixel.
void Tile::add_sample(const glm::ivec2& pixel, const glm::dvec2& at, bool first_of_pixel) {
  const glm::dmat4& world_from_camera = context_.world_from_camera;
  RayItem item;
  item.start = glm::dvec3(world_from_camera[3]);
  item.direction =
      glm::normalize(glm::dmat3(world_from_camera) * *common::pixel_direction(request_.camera, at));
  item.ray = {glm::vec3(item.start), glm::vec3(item.direction),
              std::numeric_limits<float>::infinity()};
  item.media = context_.camera_media;
  item.sample = static_cast<std::uint32_t>(paths_.samples.size());
  waiting_.push_back(item);
  paths_.samples.push_back({.pixel_x = static_cast<std::uint16_t>(pixel.x),
                            .pixel_y = static_cast<std::uint16_t>(pixel.y),
                            .first_of_pixel = first_of_pixel});
  if (request_.keep_provenance) provenance_.emplace_back();
}

}  // namespace amalgam::trace
