// How far apart two composites are.
#pragma once

#include "common/image.h"

namespace amalgam::bench {

// Mean absolute difference over all channels, in 1/255.
double mean_difference(const common::ImageRgb8& a, const common::ImageRgb8& b);

// Structural similarity of the grey pictures (Wang et al. 2004), 1 for the same picture. By OpenCV.
double ssim(const common::ImageRgb8& a, const common::ImageRgb8& b);

// The same for each pixel and its surroundings.
common::Image<float> ssim_map(const common::ImageRgb8& a, const common::ImageRgb8& b);

// Peak signal-to-noise ratio over all channels, decibels; infinite for the same picture. By OpenCV.
double psnr(const common::ImageRgb8& a, const common::ImageRgb8& b);

}  // namespace amalgam::bench
