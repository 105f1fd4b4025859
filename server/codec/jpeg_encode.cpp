#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <string>

#include "codec/jpeg.h"
#include "codec/jpeg_segments.h"
#include "codec/libjpeg.h"

// The picture is cut into bands of whole rows of MCUs. They are encoded side by side on all cores
// and become one file with a restart marker between each two. The bands depend on the picture's
// size only, so that the bytes are the same for any number of threads.

namespace amalgam::codec {
namespace {

struct Settings {
  int quality = 0;
  int luma_sampling = 1;     // both ways; chroma has 1
  int restart_interval = 0;  // MCUs
};

// Some rows of the picture as a file of their own.
std::vector<std::byte> encode_band(const common::ImageRgb8& image, int first_row, int rows,
                                   const Settings& settings) {
  MemoryCompressor band(static_cast<std::size_t>(image.width() * rows / 2));
  band.errors().guard("cannot encode JPEG", [&] {
    jpeg_compress_struct& info = band.info();
    info.image_width = static_cast<JDIMENSION>(image.width());
    info.image_height = static_cast<JDIMENSION>(rows);
    info.in_color_space = JCS_RGB;
    info.input_components = 3;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, settings.quality, TRUE);
    info.comp_info[0].h_samp_factor = info.comp_info[0].v_samp_factor = settings.luma_sampling;
    info.restart_interval = static_cast<unsigned>(settings.restart_interval);
    jpeg_start_compress(&info, TRUE);
    for (int y = first_row; y < first_row + rows; ++y) {
      // libjpeg's rows are not const, but it only reads them.
      auto row = reinterpret_cast<JSAMPROW>(const_cast<common::Rgb8*>(&image.at(0, y)));
      jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
  });
  return band.take();
}

}  // namespace

std::vector<std::byte> encode_jpeg(const common::ImageRgb8& image, int quality) {
  constexpr int kFullChromaQuality = 95;  // from here on halved chroma would be visible
  constexpr int kBandRows = 64;           // pixels; some 0.2 ms of work at 1280 pixels a row
  if (image.empty()) throw JpegError("an empty image cannot be encoded");
  if (image.width() > JPEG_MAX_DIMENSION || image.height() > JPEG_MAX_DIMENSION) {
    throw JpegError("an image of " + std::to_string(image.width()) + "x" +
                    std::to_string(image.height()) + " is too large to be encoded");
  }
  if (quality < 1 || quality > 100) {
    throw JpegError("JPEG quality " + std::to_string(quality) + " is not within 1 and 100");
  }
  const int luma_sampling = quality >= kFullChromaQuality ? 1 : 2;
  const int mcu = luma_sampling * DCTSIZE;  // pixels a side
  const int mcus_across = (image.width() + mcu - 1) / mcu;
  const Settings settings{quality, luma_sampling, mcus_across * (kBandRows / mcu)};
  const int count = (image.height() + kBandRows - 1) / kBandRows;
  std::vector<std::optional<SegmentedJpeg>> bands(static_cast<std::size_t>(count));
  tbb::parallel_for(0, count, [&](int i) {
    const int first = i * kBandRows, rows = std::min(kBandRows, image.height() - first);
    bands[static_cast<std::size_t>(i)].emplace(encode_band(image, first, rows, settings));
  });
  std::vector<JpegSegment> segments;
  for (const auto& band : bands) segments.push_back(band->segment(0));
  std::vector<std::byte> file = join_segments(bands.front()->head(), segments);
  set_height(file, image.height());
  return file;
}

}  // namespace amalgam::codec
