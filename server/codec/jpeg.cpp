#include "codec/jpeg.h"

#include <string>

#include "codec/libjpeg.h"

namespace amalgam::codec {
namespace {

static_assert(sizeof(common::Rgb8) == 3, "libjpeg writes packed RGB");

// New for each picture: nothing of an earlier one can be left in it.
class Decompressor {
 public:
  Decompressor() {
    info_.err = errors_.manager();
    errors_.guard("cannot make a JPEG decoder", [&] { jpeg_create_decompress(&info_); });
  }
  ~Decompressor() { jpeg_destroy_decompress(&info_); }
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;

  void decode(std::span<const std::byte> jpeg, common::ImageRgb8& image) {
    bool fits = true;
    errors_.guard("damaged JPEG", [&] {
      jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(jpeg.data()),
                   static_cast<unsigned long>(jpeg.size()));
      jpeg_read_header(&info_, TRUE);
      info_.out_color_space = JCS_RGB;
      info_.dct_method = JDCT_ISLOW;
      jpeg_start_decompress(&info_);
      fits = static_cast<int>(info_.output_width) == image.width() &&
             static_cast<int>(info_.output_height) == image.height();
      if (!fits) return;
      while (info_.output_scanline < info_.output_height) {
        auto* row =
            reinterpret_cast<JSAMPROW>(&image.at(0, static_cast<int>(info_.output_scanline)));
        jpeg_read_scanlines(&info_, &row, 1);
      }
      jpeg_finish_decompress(&info_);
    });
    if (!fits) throw JpegError("damaged JPEG: it has two sizes");
  }

 private:
  LibjpegErrors errors_;
  jpeg_decompress_struct info_{};
};

}  // namespace

common::ImageRgb8 decode_jpeg(std::span<const std::byte> jpeg) {
  const JpegHeader header = read_jpeg_header(jpeg);
  // Zero-filled: no pixels of an earlier picture can be left in it.
  common::ImageRgb8 image(header.width, header.height);
  Decompressor().decode(jpeg, image);
  return image;
}

}  // namespace amalgam::codec
