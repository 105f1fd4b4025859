// A client's picture: header, pixels and coefficients are read whole or refused, and agree.
#include "codec/jpeg.h"

#include <optional>

#include "codec/jpeg_patch.h"
#include "common/log.h"
#include "fuzz/target.h"

namespace amalgam::fuzz {
namespace {

template <typename Read>
auto unless_refused(Read read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const codec::JpegError&) {
    return std::nullopt;
  }
}

std::string text_of(const codec::JpegHeader& header) {
  return std::to_string(header.width) + "x" + std::to_string(header.height);
}

void check_patch(codec::JpegCoefficients coefficients, const common::ImageRgb8& picture) {
  const int tiles_across = (picture.width() + codec::kPatchTile - 1) / codec::kPatchTile;
  const int tiles_down = (picture.height() + codec::kPatchTile - 1) / codec::kPatchTile;
  std::vector<std::uint8_t> tiles(static_cast<std::size_t>(tiles_across * tiles_down));
  for (std::size_t i = 0; i < tiles.size(); i += 2) tiles[i] = 1;
  const auto patched = codec::patch_jpeg(std::move(coefficients), picture, tiles);
  if (!patched) return;
  const common::ImageRgb8 read = codec::decode_jpeg(*patched);  // throws if it is broken
  AMALGAM_CHECK(read.size() == picture.size(), "the patch has another size");
}

}  // namespace
}  // namespace amalgam::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amalgam;
  // Large ones only take longer.
  constexpr int kMaxPixels = 128 * 128;
  const auto bytes = fuzz::as_bytes(data, size);
  const auto header = fuzz::unless_refused([&] { return codec::read_jpeg_header(bytes); });
  if (header) {
    AMALGAM_CHECK(header->width >= 1 && header->width <= codec::kMaxJpegSide &&
                      header->height >= 1 && header->height <= codec::kMaxJpegSide,
                  fuzz::text_of(*header));
    if (header->width * header->height > kMaxPixels) return -1;
  }
  const auto picture = fuzz::unless_refused([&] { return codec::decode_jpeg(bytes); });
  AMALGAM_CHECK(header || !picture, "decoded without a good header");
  if (!header) return 0;
  auto coefficients = fuzz::unless_refused([&] { return codec::JpegCoefficients::read(bytes); });
  AMALGAM_CHECK(coefficients.has_value() == picture.has_value(),
                "only one of pixels and coefficients can be read");
  if (!picture) return 0;
  AMALGAM_CHECK(picture->width() == header->width && picture->height() == header->height,
                "the header says " + fuzz::text_of(*header));
  if (*coefficients) fuzz::check_patch(std::move(**coefficients), *picture);
  return 0;
}
