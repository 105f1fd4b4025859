#include "scene/mip_chain.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "scene/light/tone_map.h"

namespace amalgam::scene {
namespace {

using LinearImage = common::Image<glm::vec4>;

LinearImage decoded(const common::ImageRgba8& texels, TexelEncoding encoding) {
  LinearImage out(texels.width(), texels.height());
  const auto decode = [&](std::uint8_t byte) {
    return encoding == TexelEncoding::Srgb ? srgb_decode(byte) : static_cast<float>(byte) / 255.0f;
  };
  for (int y = 0; y < texels.height(); ++y) {
    for (int x = 0; x < texels.width(); ++x) {
      const common::Rgba8& texel = texels.at(x, y);
      out.at(x, y) = {decode(texel.x), decode(texel.y), decode(texel.z),
                      static_cast<float>(texel.w) / 255.0f};
    }
  }
  return out;
}

std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

common::ImageRgba8 encoded(const LinearImage& image, TexelEncoding encoding) {
  common::ImageRgba8 out(image.width(), image.height());
  const auto encode = [&](float value) {
    return encoding == TexelEncoding::Srgb ? srgb_encode(value) : to_byte(value);
  };
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec4& v = image.at(x, y);
      out.at(x, y) = {encode(v.x), encode(v.y), encode(v.z), to_byte(v.w)};
    }
  }
  return out;
}

// Mean of `size` values over the half-open interval that output i of `halved` covers. An even size
// has two equal weights, an odd one three.
template <typename Value>
glm::vec4 mean_over(int i, int size, int halved, const Value& value) {
  const double step = static_cast<double>(size) / halved;
  const double low = i * step, high = low + step;
  glm::vec4 sum(0.0f);
  for (int j = static_cast<int>(low); j < size && j < high; ++j) {
    const double covered = std::min(high, j + 1.0) - std::max(low, static_cast<double>(j));
    sum += static_cast<float>(covered / step) * value(j);
  }
  return sum;
}

LinearImage halved(const LinearImage& image) {
  const int width = std::max(image.width() / 2, 1), height = std::max(image.height() / 2, 1);
  LinearImage rows(width, image.height()), out(width, height);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < width; ++x) {
      rows.at(x, y) =
          mean_over(x, image.width(), width, [&](int from) { return image.at(from, y); });
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      out.at(x, y) =
          mean_over(y, image.height(), height, [&](int from) { return rows.at(x, from); });
    }
  }
  return out;
}

}  // namespace

std::vector<common::ImageRgba8> make_mips(const common::ImageRgba8& texels,
                                          TexelEncoding encoding) {
  std::vector<common::ImageRgba8> mips;
  LinearImage image = decoded(texels, encoding);
  while (image.width() > 1 || image.height() > 1) {
    image = halved(image);
    mips.push_back(encoded(image, encoding));
  }
  return mips;
}

}  // namespace amalgam::scene
