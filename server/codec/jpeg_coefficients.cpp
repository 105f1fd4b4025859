#include <algorithm>
#include <cstdlib>

#include "codec/jpeg_camera.h"
#include "codec/jpeg_metadata.h"
#include "codec/jpeg_patch.h"

namespace amalgam::codec {
namespace {

// Whether the encoder can use the quantisation table. libjpeg checks neither bound.
bool encodable(const JQUANT_TBL* table) {
  return table != nullptr && std::all_of(std::begin(table->quantval), std::end(table->quantval),
                                         [](UINT16 step) { return step >= 1 && step <= 255; });
}

bool tables_are_encodable(CoefficientReader& reader) {
  for (const jpeg_component_info& component : reader.components()) {
    const JQUANT_TBL* named = reader.info().quant_tbl_ptrs[component.quant_tbl_no];
    if (!encodable(named)) return false;
    // The table as it was when the component's scan began: a later one may have replaced it.
    const JQUANT_TBL* used = component.quant_table;
    if (used != nullptr && !std::equal(std::begin(used->quantval), std::end(used->quantval),
                                       std::begin(named->quantval))) {
      return false;
    }
  }
  return true;
}

bool fits_one_scan(CoefficientReader& reader) {
  int blocks = 0;
  for (const jpeg_component_info& component : reader.components()) {
    blocks += component.h_samp_factor * component.v_samp_factor;
  }
  return reader.components().size() == 1 || blocks <= C_MAX_BLOCKS_IN_MCU;
}

// The standard Huffman tables have codes for AC coefficients of 10 bits and DC differences of 11.
bool in_range(const JBLOCK& block) {
  constexpr int kMaxAc = 1023, kMinDc = -1024, kMaxDc = 1023;
  int bits = 0;
  for (int i = 1; i < DCTSIZE2; ++i) bits |= std::abs(int{block[i]});
  return bits <= kMaxAc && block[0] >= kMinDc && block[0] <= kMaxDc;
}

bool coefficients_are_in_range(CoefficientReader& reader, const McuGrid& grid) {
  bool good = true;
  reader.errors().guard("cannot read coefficients", [&] {
    for (int c = 0; c < reader.info().num_components; ++c) {
      const glm::ivec2 blocks = grid.blocks[static_cast<std::size_t>(c)];
      for (int y = 0; y < grid.down * blocks.y; ++y) {
        const JBLOCKROW row = block_rows(reader.info(), reader.arrays()[c], y, 1, true)[0];
        for (int x = 0; x < grid.across * blocks.x; ++x) good = good && in_range(row[x]);
      }
    }
  });
  return good;
}

}  // namespace

std::optional<JpegCoefficients> JpegCoefficients::read(std::span<const std::byte> jpeg) {
  const JpegHeader header = read_jpeg_header(jpeg);
  auto reader = std::make_unique<CoefficientReader>(jpeg);
  const J_COLOR_SPACE wanted =
      header.subsampling == JpegSubsampling::Grey ? JCS_GRAYSCALE : JCS_YCbCr;
  const McuGrid grid(reader->info());
  if (reader->info().jpeg_color_space != wanted || !fits_one_scan(*reader) ||
      !tables_are_encodable(*reader) || !coefficients_are_in_range(*reader, grid)) {
    return std::nullopt;
  }
  SegmentedJpeg segments(write_coefficients(*reader, grid.segment));
  return JpegCoefficients(std::make_unique<CameraJpeg>(
      CameraJpeg{header, std::move(reader), grid, std::move(segments), jpeg_metadata(jpeg)}));
}

const JpegHeader& JpegCoefficients::header() const {
  return camera_->header;
}

JpegCoefficients::JpegCoefficients(std::unique_ptr<CameraJpeg> camera)
    : camera_(std::move(camera)) {}

JpegCoefficients::JpegCoefficients(JpegCoefficients&&) noexcept = default;
JpegCoefficients& JpegCoefficients::operator=(JpegCoefficients&&) noexcept = default;
JpegCoefficients::~JpegCoefficients() = default;

}  // namespace amalgam::codec
