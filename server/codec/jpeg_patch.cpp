#include "codec/jpeg_patch.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "codec/jpeg_camera.h"
#include "codec/jpeg_metadata.h"
#include "common/log.h"

// The camera's file was cut into segments of a few MCUs when it was read. Segments without a
// touched MCU are copied. The others are encoded from the composite; if they also have untouched
// MCUs, those get the camera's coefficients back. An MCU's coefficients depend on its own pixels
// only (chroma is halved by averages within it), so its neighbours do not matter when it is
// encoded.

namespace amalgam::codec {
namespace {

// A flag for each MCU: whether it overlaps a flagged tile.
std::vector<bool> touched_mcus(const McuGrid& grid, std::span<const std::uint8_t> tiles) {
  const int tiles_across = (grid.picture.x + kPatchTile - 1) / kPatchTile;
  std::vector<bool> touched(static_cast<std::size_t>(grid.count()));
  for (int i = 0; i < grid.count(); ++i) {
    const glm::ivec2 first = grid.begin(i) / kPatchTile;
    const glm::ivec2 last = (grid.end(i) - 1) / kPatchTile;
    for (int y = first.y; y <= last.y; ++y) {
      const auto row = tiles.begin() + y * tiles_across;
      if (std::any_of(row + first.x, row + last.x + 1, [](std::uint8_t flag) { return flag != 0; }))
        touched[static_cast<std::size_t>(i)] = true;
    }
  }
  return touched;
}

// Segments to be made anew together, by their numbers.
struct Job {
  bool mixed = false;  // they have untouched MCUs too
  std::vector<int> segments;
};

std::vector<Job> make_jobs(const McuGrid& grid, const std::vector<bool>& touched) {
  constexpr std::size_t kJobSegments = 48;  // enough to make the cost of an encoder negligible
  std::vector<Job> jobs;
  std::array<Job, 2> open{Job{false, {}}, Job{true, {}}};
  for (int i = 0; i < grid.segments(); ++i) {
    const auto begin = touched.begin() + i * grid.segment;
    const auto count = std::count(begin, begin + grid.segment, true);
    if (count == 0) continue;
    Job& job = open[count < grid.segment ? 1 : 0];
    job.segments.push_back(i);
    if (job.segments.size() == kJobSegments) {
      jobs.push_back(job);
      job.segments.clear();
    }
  }
  for (const Job& job : open) {
    if (!job.segments.empty()) jobs.push_back(job);
  }
  return jobs;
}

bool is_grey(const common::ImageRgb8& image, const McuGrid& grid,
             const std::vector<bool>& touched) {
  for (int i = 0; i < grid.count(); ++i) {
    if (!touched[static_cast<std::size_t>(i)]) continue;
    const glm::ivec2 begin = grid.begin(i), end = grid.end(i);
    for (int y = begin.y; y < end.y; ++y) {
      for (int x = begin.x; x < end.x; ++x) {
        const common::Rgb8& pixel = image.at(x, y);
        if (pixel.x != pixel.y || pixel.x != pixel.z) return false;
      }
    }
  }
  return true;
}

// strip: the encoded mixed segments below each other. Gives their untouched MCUs the camera's
// coefficients.
void put_back(CoefficientReader& camera, const McuGrid& grid, const std::vector<bool>& touched,
              std::span<const int> mixed, CoefficientReader& strip) {
  const auto copy_mcu = [&](int c, int index, const glm::ivec2& to_place) {
    const glm::ivec2 blocks = grid.blocks[static_cast<std::size_t>(c)];
    const glm::ivec2 from_place = grid.place(index);
    const JBLOCKARRAY from =
        block_rows(strip.info(), camera.arrays()[c], from_place.y * blocks.y, blocks.y, false);
    const JBLOCKARRAY to =
        block_rows(strip.info(), strip.arrays()[c], to_place.y * blocks.y, blocks.y, true);
    for (int row = 0; row < blocks.y; ++row) {
      std::memcpy(to[row] + to_place.x * blocks.x, from[row] + from_place.x * blocks.x,
                  static_cast<std::size_t>(blocks.x) * sizeof(JBLOCK));
    }
  };
  strip.errors().guard("cannot patch", [&] {
    for (int y = 0; y < static_cast<int>(mixed.size()); ++y) {
      for (int x = 0; x < grid.segment; ++x) {
        const int index = mixed[static_cast<std::size_t>(y)] * grid.segment + x;
        if (touched[static_cast<std::size_t>(index)]) continue;
        for (int c = 0; c < strip.info().num_components; ++c) copy_mcu(c, index, {x, y});
      }
    }
  });
}

std::vector<std::byte> encode(CameraJpeg& camera, const common::ImageRgb8& composite,
                              const std::vector<bool>& touched, const Job& job) {
  const McuGrid& grid = camera.grid;
  std::vector<std::byte> strip =
      encode_segments(camera.reader->info(), grid, composite, job.segments);
  if (!job.mixed) return strip;
  CoefficientReader reader(strip);
  put_back(*camera.reader, grid, touched, job.segments, reader);
  return write_coefficients(reader, grid.segment);
}

}  // namespace

std::optional<std::vector<std::byte>> patch_jpeg(JpegCoefficients coefficients,
                                                 const common::ImageRgb8& composite,
                                                 std::span<const std::uint8_t> tiles) {
  CameraJpeg& camera = *coefficients.camera_;
  const McuGrid& grid = camera.grid;
  const glm::ivec2 size = grid.picture, tile_grid = (size + kPatchTile - 1) / kPatchTile;
  AMALGAM_CHECK(composite.size() == size &&
                    tiles.size() == static_cast<std::size_t>(tile_grid.x * tile_grid.y),
                "the camera's picture is " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                    ", the composite " + std::to_string(composite.width()) + "x" +
                    std::to_string(composite.height()) + " with " + std::to_string(tiles.size()) +
                    " tiles");
  const std::vector<bool> touched = touched_mcus(grid, tiles);
  const bool grey = camera.header.subsampling == JpegSubsampling::Grey;
  if (grey && !is_grey(composite, grid, touched)) return std::nullopt;

  const std::vector<Job> jobs = make_jobs(grid, touched);
  std::vector<std::optional<SegmentedJpeg>> made(jobs.size());
  tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
    made[i].emplace(encode(camera, composite, touched, jobs[i]));
  });

  std::vector<JpegSegment> segments;
  for (std::size_t i = 0; i < camera.segments.count(); ++i) {
    segments.push_back(camera.segments.segment(i));
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    for (std::size_t k = 0; k < jobs[i].segments.size(); ++k) {
      segments[static_cast<std::size_t>(jobs[i].segments[k])] = made[i]->segment(k);
    }
  }
  std::vector<std::byte> file = join_segments(camera.segments.head(), segments);
  insert_metadata(file, camera.metadata);
  return file;
}

}  // namespace amalgam::codec
