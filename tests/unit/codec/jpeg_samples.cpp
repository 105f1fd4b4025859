#include "jpeg_samples.h"

#include <cstdio>
// jpeglib.h uses FILE without including it.
#include <jpeglib.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <random>

// libjpeg's standard error handler ends the program: good enough for files that must be good.

namespace amalgam::tests {
namespace {

// A decompressor that has read the header.
struct Reader {
  explicit Reader(const Bytes& jpeg) {
    info.err = jpeg_std_error(&errors);
    jpeg_create_decompress(&info);
    jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(jpeg.data()),
                 static_cast<unsigned long>(jpeg.size()));
    jpeg_read_header(&info, TRUE);
  }
  ~Reader() { jpeg_destroy_decompress(&info); }

  jpeg_error_mgr errors{};
  jpeg_decompress_struct info{};
};

// A compressor into memory.
struct Writer {
  Writer() {
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    jpeg_mem_dest(&info, &buffer, &size);
  }
  ~Writer() {
    jpeg_destroy_compress(&info);
    std::free(buffer);
  }
  Bytes finish() {
    jpeg_finish_compress(&info);
    const auto* bytes = reinterpret_cast<const std::byte*>(buffer);
    return {bytes, bytes + size};
  }

  jpeg_error_mgr errors{};
  jpeg_compress_struct info{};
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
};

J_COLOR_SPACE space_of(SampleColor color) {
  if (color == SampleColor::Grey) return JCS_GRAYSCALE;
  return color == SampleColor::Rgb ? JCS_RGB : JCS_YCbCr;
}

JBLOCKARRAY row_of(jpeg_decompress_struct& info, jvirt_barray_ptr array, int row) {
  return info.mem->access_virt_barray(reinterpret_cast<j_common_ptr>(&info), array,
                                      static_cast<JDIMENSION>(row), 1, TRUE);
}

Bytes with_dc(const Bytes& jpeg, int dc) {
  Reader reader(jpeg);
  Writer writer;
  jvirt_barray_ptr* arrays = jpeg_read_coefficients(&reader.info);
  for (int c = 0; c < reader.info.num_components; ++c) {
    const jpeg_component_info& component = reader.info.comp_info[c];
    for (JDIMENSION y = 0; y < component.height_in_blocks; ++y) {
      const JBLOCKROW row = row_of(reader.info, arrays[c], static_cast<int>(y))[0];
      for (JDIMENSION x = 0; x < component.width_in_blocks; ++x) {
        row[x][0] = static_cast<JCOEF>(dc);
      }
    }
  }
  jpeg_copy_critical_parameters(&reader.info, &writer.info);
  jpeg_write_coefficients(&writer.info, arrays);
  return writer.finish();
}

}  // namespace

Bytes sample_jpeg(const common::ImageRgb8& image, const SampleKind& kind) {
  Writer writer;
  jpeg_compress_struct& info = writer.info;
  info.image_width = static_cast<JDIMENSION>(image.width());
  info.image_height = static_cast<JDIMENSION>(image.height());
  info.input_components = 3;
  info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_colorspace(&info, space_of(kind.color));
  jpeg_set_quality(&info, kind.quality, TRUE);
  info.write_JFIF_header = kind.jfif ? info.write_JFIF_header : FALSE;
  info.restart_interval = static_cast<unsigned>(kind.restart_interval);
  std::array<jpeg_scan_info, 3> scans{};
  for (int c = 0; c < info.num_components; ++c) {
    jpeg_component_info& component = info.comp_info[c];
    const auto& factors = c == 0 ? kind.luma : kind.chroma;
    component.h_samp_factor = factors[0];
    component.v_samp_factor = factors[1];
    if (kind.color == SampleColor::YCbCr) {
      component.component_id = kind.ids[static_cast<std::size_t>(c)];
    }
    scans[static_cast<std::size_t>(c)] = {1, {c, 0, 0, 0}, 0, 63, 0, 0};
  }
  if (kind.scan_for_each_component) {
    info.scan_info = scans.data();
    info.num_scans = info.num_components;
  }
  jpeg_start_compress(&info, TRUE);
  common::ImageRgb8 copy = image;  // libjpeg's rows are not const
  while (info.next_scanline < info.image_height) {
    auto row = reinterpret_cast<JSAMPROW>(&copy.at(0, static_cast<int>(info.next_scanline)));
    jpeg_write_scanlines(&info, &row, 1);
  }
  const Bytes jpeg = writer.finish();
  return kind.bright_dc == 0 ? jpeg : with_dc(jpeg, kind.bright_dc);
}

Bytes with_segment(const Bytes& jpeg, int number, std::span<const char> content) {
  const std::size_t length = content.size() + 2;
  Bytes segment{std::byte{0xFF}, static_cast<std::byte>(0xE0 + number),
                static_cast<std::byte>(length >> 8), static_cast<std::byte>(length & 255)};
  const auto* bytes = reinterpret_cast<const std::byte*>(content.data());
  segment.insert(segment.end(), bytes, bytes + content.size());
  Bytes out = jpeg;
  out.insert(out.begin() + 2, segment.begin(), segment.end());
  return out;
}

common::ImageRgb8 noisy_picture(int width, int height, unsigned seed, bool grey) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> noise(0, 100);
  common::ImageRgb8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      common::Rgb8& pixel = image.at(x, y);
      pixel = common::Rgb8(150 * x / width + noise(random), 150 * y / height + noise(random),
                           static_cast<int>(seed * 40 % 150) + noise(random));
      if (grey) pixel = common::Rgb8(pixel.x);
    }
  }
  return image;
}

std::vector<ComponentBlocks> blocks_of(const Bytes& jpeg) {
  Reader reader(jpeg);
  jvirt_barray_ptr* arrays = jpeg_read_coefficients(&reader.info);
  std::vector<ComponentBlocks> components;
  for (int c = 0; c < reader.info.num_components; ++c) {
    const jpeg_component_info& from = reader.info.comp_info[c];
    ComponentBlocks& to = components.emplace_back();
    to.across = static_cast<int>(from.width_in_blocks);
    to.down = static_cast<int>(from.height_in_blocks);
    to.per_mcu_x = from.h_samp_factor;
    to.per_mcu_y = from.v_samp_factor;
    std::copy_n(from.quant_table->quantval, 64, to.quantisation.begin());
    for (int y = 0; y < to.down; ++y) {
      const JBLOCKROW row = row_of(reader.info, arrays[c], y)[0];
      for (int x = 0; x < to.across; ++x) {
        std::copy_n(row[x], 64, to.blocks.emplace_back().begin());
      }
    }
  }
  return components;
}

common::ImageRgb8 decode_unsmoothed(const Bytes& jpeg) {
  Reader reader(jpeg);
  jpeg_decompress_struct& info = reader.info;
  info.do_fancy_upsampling = FALSE;
  info.out_color_space = JCS_RGB;
  common::ImageRgb8 image(static_cast<int>(info.image_width), static_cast<int>(info.image_height));
  jpeg_start_decompress(&info);
  while (info.output_scanline < info.output_height) {
    auto row = reinterpret_cast<JSAMPROW>(&image.at(0, static_cast<int>(info.output_scanline)));
    jpeg_read_scanlines(&info, &row, 1);
  }
  return image;
}

}  // namespace amalgam::tests
