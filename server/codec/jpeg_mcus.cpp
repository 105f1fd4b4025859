#include "codec/jpeg_mcus.h"

#include <algorithm>
#include <cstring>

namespace amalgam::codec {
namespace {

// Pixels. Shorter segments are replaced more precisely, but each costs some 5 bytes. The shortest
// one that is at least this long and divides the picture evenly is taken.
constexpr int kLeastSegmentWidth = 96;

// Copies an MCU's pixels. Beyond the picture's right and bottom border its last pixels are
// repeated, as in any encoder.
void copy_mcu(const common::ImageRgb8& from, const McuGrid& grid, int index, common::ImageRgb8& to,
              int to_x) {
  const glm::ivec2 begin = grid.begin(index);
  const int inside = grid.end(index).x - begin.x;
  for (int row = 0; row < grid.size.y; ++row) {
    const int y = std::min(begin.y + row, from.height() - 1);
    common::Rgb8* out = &to.at(to_x, row);
    std::copy_n(&from.at(begin.x, y), inside, out);
    std::fill(out + inside, out + grid.size.x, out[inside - 1]);
  }
}

}  // namespace

McuGrid::McuGrid(const jpeg_decompress_struct& info)
    : picture(static_cast<int>(info.image_width), static_cast<int>(info.image_height)) {
  if (info.num_components == 1) {
    // A single component is coded block by block, whatever its sampling factors.
    blocks[0] = {1, 1};
    size = {DCTSIZE, DCTSIZE};
  } else {
    for (std::size_t c = 0; c < blocks.size(); ++c) {
      blocks[c] = {info.comp_info[c].h_samp_factor, info.comp_info[c].v_samp_factor};
    }
    size = {info.max_h_samp_factor * DCTSIZE, info.max_v_samp_factor * DCTSIZE};
  }
  across = (picture.x + size.x - 1) / size.x;
  down = (picture.y + size.y - 1) / size.y;
  segment = std::min((kLeastSegmentWidth + size.x - 1) / size.x, count());
  while (count() % segment != 0) ++segment;
}

std::vector<std::byte> encode_segments(jpeg_decompress_struct& camera, const McuGrid& grid,
                                       const common::ImageRgb8& picture,
                                       std::span<const int> segments) {
  constexpr int kMaxMcuHeight = 4 * DCTSIZE;
  common::ImageRgb8 pixels(grid.segment * grid.size.x, grid.size.y);  // of one segment
  std::array<JSAMPROW, kMaxMcuHeight> rows{};
  for (int y = 0; y < grid.size.y; ++y) {
    rows[static_cast<std::size_t>(y)] = reinterpret_cast<JSAMPROW>(&pixels.at(0, y));
  }
  MemoryCompressor strip(segments.size() * pixels.pixels().size() / 2);
  strip.errors().guard("cannot encode touched blocks", [&] {
    jpeg_compress_struct& info = strip.info();
    jpeg_copy_critical_parameters(&camera, &info);
    info.image_width = static_cast<JDIMENSION>(pixels.width());
    info.image_height = static_cast<JDIMENSION>(static_cast<int>(segments.size()) * grid.size.y);
    info.in_color_space = JCS_RGB;
    info.input_components = 3;
    info.restart_interval = static_cast<unsigned>(grid.segment);
    for (int c = 0; c < info.num_components; ++c) {
      info.comp_info[c].h_samp_factor = grid.blocks[static_cast<std::size_t>(c)].x;
      info.comp_info[c].v_samp_factor = grid.blocks[static_cast<std::size_t>(c)].y;
    }
    jpeg_start_compress(&info, TRUE);
    for (const int segment : segments) {
      for (int i = 0; i < grid.segment; ++i) {
        copy_mcu(picture, grid, segment * grid.segment + i, pixels, i * grid.size.x);
      }
      jpeg_write_scanlines(&info, rows.data(), static_cast<JDIMENSION>(grid.size.y));
    }
    jpeg_finish_compress(&info);
  });
  return strip.take();
}

std::vector<std::byte> write_coefficients(CoefficientReader& from, int interval) {
  jpeg_decompress_struct& source = from.info();
  MemoryCompressor out(std::size_t{source.image_width} * source.image_height / 2);
  out.errors().guard("cannot write JPEG coefficients", [&] {
    jpeg_compress_struct& info = out.info();
    jpeg_copy_critical_parameters(&source, &info);
    info.restart_interval = static_cast<unsigned>(interval);
    jpeg_write_coefficients(&info, from.arrays());
    jpeg_finish_compress(&info);
  });
  return out.take();
}

}  // namespace amalgam::codec
