// How far apart two composites are.
#pragma once

#include "core/image.h"

namespace amalgam::bench {

// Mean absolute difference over all channels, in 1/255.
double mean_difference(const core::ImageRgb8& a, const core::ImageRgb8& b);

// Structural similarity of the grey pictures (Wang et al. 2004), 1 for the same picture. By OpenCV.
double ssim(const core::ImageRgb8& a, const core::ImageRgb8& b);

}  // namespace amalgam::bench
