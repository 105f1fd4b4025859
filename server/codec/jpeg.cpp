#include "codec/jpeg.h"

#include <turbojpeg.h>

#include <memory>
#include <string>

namespace amalgam::codec {
namespace {

static_assert(sizeof(core::Rgb8) == 3, "turbojpeg reads and writes packed RGB");

struct HandleCloser {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, HandleCloser>;

struct BufferCloser {
  void operator()(unsigned char* buffer) const { tjFree(buffer); }
};

[[noreturn]] void fail(const char* what, const Handle& handle) {
  throw JpegError(std::string(what) + ": " + tjGetErrorStr2(handle.get()));
}

}  // namespace

core::ImageRgb8 decode_jpeg(std::span<const std::byte> jpeg) {
  const JpegHeader header = read_jpeg_header(jpeg);
  // A new decoder and a zero-filled image each time: nothing of an earlier picture can be left in
  // them.
  const Handle decoder(tjInitDecompress());
  if (!decoder) throw JpegError("cannot make a JPEG decoder");
  core::ImageRgb8 image(header.width, header.height);
  const int status = tjDecompress2(
      decoder.get(), reinterpret_cast<const unsigned char*>(jpeg.data()),
      static_cast<unsigned long>(jpeg.size()), reinterpret_cast<unsigned char*>(image.data()),
      header.width, 3 * header.width, header.height, TJPF_RGB,
      TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT);
  if (status != 0) fail("damaged JPEG", decoder);
  return image;
}

std::vector<std::byte> encode_jpeg(const core::ImageRgb8& image, int quality) {
  constexpr int kFullChromaQuality = 95;  // who asks for this much can see halved chroma
  if (image.empty()) throw JpegError("an empty image cannot be encoded");
  if (quality < 1 || quality > 100) {
    throw JpegError("JPEG quality " + std::to_string(quality) + " is not within 1 and 100");
  }
  const Handle encoder(tjInitCompress());
  if (!encoder) throw JpegError("cannot make a JPEG encoder");
  unsigned char* raw = nullptr;
  unsigned long size = 0;
  const int status =
      tjCompress2(encoder.get(), reinterpret_cast<const unsigned char*>(image.data()),
                  image.width(), 3 * image.width(), image.height(), TJPF_RGB, &raw, &size,
                  quality >= kFullChromaQuality ? TJSAMP_444 : TJSAMP_420, quality, 0);
  const std::unique_ptr<unsigned char, BufferCloser> buffer(raw);
  if (status != 0) fail("cannot encode JPEG", encoder);
  const auto* bytes = reinterpret_cast<const std::byte*>(buffer.get());
  return {bytes, bytes + size};
}

}  // namespace amalgam::codec
