#include "codec/jpeg_patch.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "codec/libjpeg.h"
#include "core/log.h"

// Touched MCUs are packed side by side into one small picture, the strip. libjpeg encodes it, and
// the coefficients read back from it go into the places of the camera's. An MCU's coefficients
// depend on its own pixels only (chroma is halved by averages that do not reach beyond it), so that
// it does not matter which MCUs are neighbours in the strip.

namespace amalgam::codec {
namespace {

struct Mcu {
  int x = 0;
  int y = 0;
};

// How the camera's picture is divided, and which parts of it are touched.
struct Plan {
  int mcu_width = 0;   // pixels
  int mcu_height = 0;  // pixels
  std::vector<Mcu> touched;
  int strip_width = 1;  // MCUs

  int strip_height() const {
    return (static_cast<int>(touched.size()) + strip_width - 1) / strip_width;
  }
};

// Whether any tile that the MCU overlaps is flagged.
bool is_touched(const Plan& plan, const Mcu& mcu, const glm::ivec2& size,
                std::span<const std::uint8_t> flags) {
  const int across = (size.x + kPatchTile - 1) / kPatchTile;
  const int right = std::min((mcu.x + 1) * plan.mcu_width, size.x) - 1;
  const int bottom = std::min((mcu.y + 1) * plan.mcu_height, size.y) - 1;
  for (int y = mcu.y * plan.mcu_height / kPatchTile; y <= bottom / kPatchTile; ++y) {
    for (int x = mcu.x * plan.mcu_width / kPatchTile; x <= right / kPatchTile; ++x) {
      if (flags[static_cast<std::size_t>(y * across + x)] != 0) return true;
    }
  }
  return false;
}

Plan make_plan(const jpeg_decompress_struct& info, const glm::ivec2& size,
               std::span<const std::uint8_t> flags) {
  Plan plan;
  plan.mcu_width = info.max_h_samp_factor * DCTSIZE;
  plan.mcu_height = info.max_v_samp_factor * DCTSIZE;
  const int across = (size.x + plan.mcu_width - 1) / plan.mcu_width;
  const int down = (size.y + plan.mcu_height - 1) / plan.mcu_height;
  for (int y = 0; y < down; ++y) {
    for (int x = 0; x < across; ++x) {
      if (is_touched(plan, {x, y}, size, flags)) plan.touched.push_back({x, y});
    }
  }
  // As wide as the picture: its width is within every limit, one long row need not be.
  plan.strip_width = std::clamp(static_cast<int>(plan.touched.size()), 1, across);
  return plan;
}

bool is_grey(const core::ImageRgb8& image, const Plan& plan) {
  for (const Mcu& mcu : plan.touched) {
    const int right = std::min((mcu.x + 1) * plan.mcu_width, image.width());
    const int bottom = std::min((mcu.y + 1) * plan.mcu_height, image.height());
    for (int y = mcu.y * plan.mcu_height; y < bottom; ++y) {
      for (int x = mcu.x * plan.mcu_width; x < right; ++x) {
        const core::Rgb8& pixel = image.at(x, y);
        if (pixel.x != pixel.y || pixel.x != pixel.z) return false;
      }
    }
  }
  return true;
}

// Copies an MCU's pixels; beyond the picture's right and bottom border its last ones go on, as in
// any encoder.
void copy_mcu(const core::ImageRgb8& from, const Plan& plan, const Mcu& mcu, core::ImageRgb8& to,
              int to_x) {
  const int x = mcu.x * plan.mcu_width;
  const int inside = std::min(plan.mcu_width, from.width() - x);
  for (int row = 0; row < plan.mcu_height; ++row) {
    const int y = std::min(mcu.y * plan.mcu_height + row, from.height() - 1);
    core::Rgb8* out = &to.at(to_x, row);
    std::copy_n(&from.at(x, y), inside, out);
    std::fill(out + inside, out + plan.mcu_width, out[inside - 1]);
  }
}

std::vector<std::byte> encode_strip(jpeg_decompress_struct& camera, const core::ImageRgb8& image,
                                    const Plan& plan) {
  constexpr int kMaxMcuHeight = 4 * DCTSIZE;
  const int width = plan.strip_width * plan.mcu_width;
  const std::size_t count = plan.touched.size();
  core::ImageRgb8 rows(width, plan.mcu_height);  // one row of MCUs
  std::array<JSAMPROW, kMaxMcuHeight> lines{};
  for (int y = 0; y < plan.mcu_height; ++y) {
    lines[static_cast<std::size_t>(y)] = reinterpret_cast<JSAMPROW>(&rows.at(0, y));
  }
  MemoryCompressor strip(count * static_cast<std::size_t>(plan.mcu_width * plan.mcu_height / 2));
  strip.errors().guard("cannot encode touched blocks", [&] {
    jpeg_compress_struct& info = strip.info();
    jpeg_copy_critical_parameters(&camera, &info);
    info.image_width = static_cast<JDIMENSION>(width);
    info.image_height = static_cast<JDIMENSION>(plan.strip_height() * plan.mcu_height);
    info.in_color_space = JCS_RGB;
    info.input_components = 3;
    jpeg_start_compress(&info, TRUE);
    for (std::size_t next = 0; next < count;) {
      for (int i = 0; i < plan.strip_width && next < count; ++i, ++next) {
        copy_mcu(image, plan, plan.touched[next], rows, i * plan.mcu_width);
      }
      jpeg_write_scanlines(&info, lines.data(), static_cast<JDIMENSION>(plan.mcu_height));
    }
    jpeg_finish_compress(&info);
  });
  return strip.take();
}

// From the strip to the places in the camera's picture.
void scatter(CoefficientReader& strip, const Plan& plan, CoefficientReader& camera) {
  const auto move_component = [&](int c) {
    const jpeg_component_info& component = camera.info().comp_info[c];
    const auto blocks = static_cast<std::size_t>(component.h_samp_factor);
    for (std::size_t i = 0; i < plan.touched.size(); ++i) {
      const int strip_x = static_cast<int>(i) % plan.strip_width;
      const Mcu& mcu = plan.touched[i];
      const JBLOCKARRAY from = strip.mcu_row(c, static_cast<int>(i) / plan.strip_width);
      const JBLOCKARRAY to = camera.mcu_row(c, mcu.y);
      for (int line = 0; line < component.v_samp_factor; ++line) {
        std::memcpy(to[line] + static_cast<std::size_t>(mcu.x) * blocks,
                    from[line] + static_cast<std::size_t>(strip_x) * blocks,
                    blocks * sizeof(JBLOCK));
      }
    }
  };
  // Two libraries' objects, two places an error can be reported to.
  camera.errors().guard("cannot patch", [&] {
    strip.errors().guard("cannot patch", [&] {
      for (int c = 0; c < camera.info().num_components; ++c) move_component(c);
    });
  });
}

std::vector<std::byte> write(CoefficientReader& camera, std::size_t expected) {
  MemoryCompressor out(expected);
  out.errors().guard("cannot write patched JPEG", [&] {
    jpeg_compress_struct& info = out.info();
    jpeg_copy_critical_parameters(&camera.info(), &info);
    jpeg_write_coefficients(&info, camera.arrays());
    for (auto marker = camera.info().marker_list; marker != nullptr; marker = marker->next) {
      constexpr char kIcc[] = "ICC_PROFILE";
      if (marker->data_length > sizeof kIcc && std::memcmp(marker->data, kIcc, sizeof kIcc) == 0) {
        jpeg_write_marker(&info, marker->marker, marker->data, marker->data_length);
      }
    }
    jpeg_finish_compress(&info);
  });
  return out.take();
}

}  // namespace

std::optional<std::vector<std::byte>> patch_jpeg(JpegCoefficients camera,
                                                 const core::ImageRgb8& composite,
                                                 std::span<const std::uint8_t> touched) {
  const glm::ivec2 size(camera.header_.width, camera.header_.height);
  const glm::ivec2 tiles = (size + kPatchTile - 1) / kPatchTile;
  AMALGAM_CHECK(
      composite.size() == size && touched.size() == static_cast<std::size_t>(tiles.x * tiles.y),
      "the camera's picture is " + std::to_string(size.x) + "x" + std::to_string(size.y) +
          ", the composite " + std::to_string(composite.width()) + "x" +
          std::to_string(composite.height()) + " with " + std::to_string(touched.size()) +
          " tiles");
  CoefficientReader& reader = *camera.reader_;
  const Plan plan = make_plan(reader.info(), size, touched);
  const bool grey = camera.header_.subsampling == JpegSubsampling::Grey;
  if (grey && !is_grey(composite, plan)) return std::nullopt;
  if (!plan.touched.empty()) {
    CoefficientReader strip(encode_strip(reader.info(), composite, plan));
    scatter(strip, plan, reader);
  }
  return write(reader, static_cast<std::size_t>(size.x * size.y / 2));
}

}  // namespace amalgam::codec
