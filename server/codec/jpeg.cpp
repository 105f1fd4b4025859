#include "codec/jpeg.h"

#include <turbojpeg.h>

#include <memory>
#include <string>

namespace amalgam::codec {
namespace {

static_assert(sizeof(common::Rgb8) == 3, "turbojpeg reads and writes packed RGB");

struct HandleCloser {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, HandleCloser>;

[[noreturn]] void fail(const char* what, const Handle& handle) {
  throw JpegError(std::string(what) + ": " + tjGetErrorStr2(handle.get()));
}

}  // namespace

common::ImageRgb8 decode_jpeg(std::span<const std::byte> jpeg) {
  const JpegHeader header = read_jpeg_header(jpeg);
  // A new decoder and a zero-filled image each time: nothing of an earlier picture can be left in
  // them.
  const Handle decoder(tjInitDecompress());
  if (!decoder) throw JpegError("cannot make a JPEG decoder");
  common::ImageRgb8 image(header.width, header.height);
  const int status = tjDecompress2(
      decoder.get(), reinterpret_cast<const unsigned char*>(jpeg.data()),
      static_cast<unsigned long>(jpeg.size()), reinterpret_cast<unsigned char*>(image.data()),
      header.width, 3 * header.width, header.height, TJPF_RGB,
      TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT);
  if (status != 0) fail("damaged JPEG", decoder);
  return image;
}

}  // namespace amalgam::codec
