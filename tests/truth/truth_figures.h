// How far a composite is from the truth, on objects and on what is real apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/image.h"

namespace amalgam::truth {

using PixelSet = common::Image<std::uint8_t>;  // 0: not in it

// Pixels that see a virtual object, if only in part.
PixelSet object_pixels(const common::ImageRgb8& mask);

// Pixels of real surfaces that the objects change: by shadows, light and mirror images. Those at
// which the truth or one of the composites differs from the camera's image; so a shadow in the
// wrong place counts twice, where it is missing and where it is too much.
PixelSet changed_pixels(const common::ImageRgb8& mask, const common::ImageRgb8& camera,
                        const std::vector<const common::ImageRgb8*>& pictures);

struct Figures {
  double mean = 0.0;           // absolute difference over pixels and channels, 1/255
  double percentile_95 = 0.0;  // of the pixels' mean differences, 1/255
  double ssim = 1.0;           // mean over the pixels of the map of the whole picture
  std::size_t pixels = 0;
};

Figures compare(const common::ImageRgb8& actual, const common::ImageRgb8& truth,
                const PixelSet& where);

}  // namespace amalgam::truth
