#include "codec/picture.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

#include <webp/decode.h>

namespace {

// stb_image inflates a PNG for as long as its data go on, whatever size its header states: a small
// file could ask for 4 GiB. So no block may be larger than a right file of that size needs.
constexpr std::size_t kBlockForHeaders = std::size_t{1} << 20;
thread_local std::size_t largest_block = kBlockForHeaders;

void* allocate_block(std::size_t bytes) {
  return bytes <= largest_block ? std::malloc(bytes) : nullptr;
}

void* grow_block(void* block, std::size_t bytes) {
  return bytes <= largest_block ? std::realloc(block, bytes) : nullptr;
}

}  // namespace

#define STBI_MALLOC(bytes) allocate_block(bytes)
#define STBI_REALLOC(block, bytes) grow_block(block, bytes)
#define STBI_FREE(block) std::free(block)
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 8192
#include <stb/stb_image.h>

namespace amalgam::codec {

static_assert(STBI_MAX_DIMENSIONS == kMaxPictureSide);
namespace {

struct PixelCloser {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

struct Input {
  const stbi_uc* data;
  int size;
};

Input input_of(std::span<const std::byte> encoded) {
  constexpr std::size_t kMaxBytes = std::size_t{256} << 20;
  if (encoded.size() > kMaxBytes) throw PictureError("picture is larger than 256 MiB");
  return {reinterpret_cast<const stbi_uc*>(encoded.data()), static_cast<int>(encoded.size())};
}

std::string reason() {
  const char* text = stbi_failure_reason();
  if (!text) return "unknown reason";
  const std::string_view short_of_memory = "outofmem";
  return text == short_of_memory ? "needs more memory than a picture of its size may" : text;
}

glm::ivec2 checked_size(const Input& input) {
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(input.data, input.size, &width, &height, &channels)) {
    throw PictureError("not a readable picture: " + reason());
  }
  check_picture_size({width, height});
  return {width, height};
}

// While it lives, blocks may be as large as decoding needs.
class BlocksFor {
 public:
  BlocksFor(const glm::ivec2& size, std::size_t encoded_bytes) {
    // The largest is an inflated PNG of 16 bits and four channels. stb_image begins with what the
    // header needs, and doubles it if an interlaced picture needs some more. JPEGs are padded to
    // whole blocks of at most 32 pixels. Compressed bytes are collected in a block that doubles.
    constexpr std::size_t kPadding = 64, kPixelBytes = 8, kTables = std::size_t{64} << 10;
    const std::size_t width = static_cast<std::size_t>(size.x) + kPadding;
    const std::size_t height = static_cast<std::size_t>(size.y) + kPadding;
    largest_block = 2 * (kPixelBytes * width * height + encoded_bytes) + kTables;
  }
  ~BlocksFor() { largest_block = kBlockForHeaders; }
  BlocksFor(const BlocksFor&) = delete;
  BlocksFor& operator=(const BlocksFor&) = delete;
};

bool begins_with(std::span<const std::byte> bytes, std::span<const unsigned char> prefix) {
  return bytes.size() >= prefix.size() &&
         std::memcmp(bytes.data(), prefix.data(), prefix.size()) == 0;
}

constexpr std::array<unsigned char, 8> kPngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::array<unsigned char, 3> kJpegSignature{0xFF, 0xD8, 0xFF};

// stb_image stops after the last pixel and does not notice a truncated file.
bool has_png_end(std::span<const std::byte> bytes) {
  std::size_t at = kPngSignature.size();
  while (bytes.size() - at >= 12) {  // length, type, check sum
    std::uint32_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
      length = length << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
    if (std::memcmp(bytes.data() + at + 4, "IEND", 4) == 0) return true;
    if (length > bytes.size() - at - 12) return false;
    at += 12 + std::size_t{length};
  }
  return false;
}

// A scan of a progressive JPEG takes some bytes and a pass over the whole picture. Encoders write
// about ten. Embedded previews are counted too.
bool has_too_many_scans(std::span<const std::byte> jpeg) {
  constexpr std::string_view kStartOfScan = "\xFF\xDA";
  constexpr int kMaxScans = 100;
  const std::string_view text(reinterpret_cast<const char*>(jpeg.data()), jpeg.size());
  int scans = 0;
  for (std::size_t at = 0; (at = text.find(kStartOfScan, at)) != text.npos; at += 2) ++scans;
  return scans > kMaxScans;
}

bool is_webp(std::span<const std::byte> bytes) {
  constexpr std::array<unsigned char, 4> kRiff{'R', 'I', 'F', 'F'}, kWebp{'W', 'E', 'B', 'P'};
  return bytes.size() >= 12 && begins_with(bytes, kRiff) && begins_with(bytes.subspan(8), kWebp);
}

glm::ivec2 webp_size(std::span<const std::byte> encoded) {
  const Input input = input_of(encoded);
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(input.data, static_cast<std::size_t>(input.size), &features) !=
      VP8_STATUS_OK) {
    throw PictureError("not a readable picture: damaged WebP");
  }
  if (features.has_animation) throw PictureError("animated WebP is not supported");
  check_picture_size({features.width, features.height});
  return {features.width, features.height};
}

common::ImageRgba8 decode_webp(std::span<const std::byte> encoded) {
  const Input input = input_of(encoded);
  const glm::ivec2 size = webp_size(encoded);
  common::ImageRgba8 image(size.x, size.y);
  auto* const pixels = reinterpret_cast<std::uint8_t*>(image.data());
  if (!WebPDecodeRGBAInto(input.data, static_cast<std::size_t>(input.size), pixels,
                          image.pixels().size_bytes(), 4 * size.x)) {
    throw PictureError("damaged picture: WebP");
  }
  return image;
}

}  // namespace

void check_picture_size(const glm::ivec2& size) {
  if (size.x < 1 || size.y < 1 || size.x > kMaxPictureSide || size.y > kMaxPictureSide ||
      size.x > kMaxPicturePixels / size.y) {
    throw PictureError("picture size " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                       " is outside the limits (" + std::to_string(kMaxPictureSide) + " a side, " +
                       std::to_string(kMaxPicturePixels >> 20) + " Mpixel)");
  }
}

bool is_picture(std::span<const std::byte> encoded) {
  return begins_with(encoded, kPngSignature) || begins_with(encoded, kJpegSignature) ||
         is_webp(encoded);
}

void check_picture(std::span<const std::byte> encoded) {
  if (!is_picture(encoded)) throw PictureError("picture is neither PNG nor JPEG nor WebP");
  if (is_webp(encoded)) {
    webp_size(encoded);
    return;
  }
  checked_size(input_of(encoded));
  if (begins_with(encoded, kPngSignature) && !has_png_end(encoded))
    throw PictureError("PNG ends before its IEND chunk");
  if (begins_with(encoded, kJpegSignature) && has_too_many_scans(encoded))
    throw PictureError("JPEG has more than 100 scans");
}

common::ImageRgba8 decode_picture(std::span<const std::byte> encoded) {
  check_picture(encoded);
  if (is_webp(encoded)) return decode_webp(encoded);
  const Input input = input_of(encoded);
  const BlocksFor blocks(checked_size(input), encoded.size());
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, PixelCloser> pixels(
      stbi_load_from_memory(input.data, input.size, &width, &height, &channels, 4));
  if (!pixels) throw PictureError("damaged picture: " + reason());
  common::ImageRgba8 image(width, height);
  static_assert(sizeof(common::Rgba8) == 4);
  std::memcpy(static_cast<void*>(image.data()), pixels.get(), image.pixels().size_bytes());
  return image;
}

}  // namespace amalgam::codec
