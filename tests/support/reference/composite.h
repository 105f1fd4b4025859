// From samples to the picture: the layers of a pixel, and how they go onto the camera image
// (eq. 4.5, evaluated per sample).
#pragma once

#include "common/camera_model.h"
#include "common/image.h"
#include "support/reference/whitted.h"

namespace amalgam::reference {

struct Layers {
  common::Image<Vec4> over;         // A = mean(M_v (TM(I_m) + I_e)); alpha: a = mean(M_v)
  common::Image<Color> difference;  // D = mean((1 - M_v) (TM(I_m) - TM(I_r)))
};

// Adds one sample's share to a pixel; weight: 1 over the number of samples.
void add_sample(Layers& layers, int x, int y, const Sample& sample, double exposure, double weight);

// The layers as the distorted camera sees them: bilinear, 0 outside the ideal image. The ideal
// camera is the one that the layers were rendered with.
Layers warp(const Layers& layers, const common::CameraModel& camera,
            const common::CameraModel& ideal);

// I_f = A + (1 - a) I_c + D, sRGB-encoded and rounded. All of the camera image's size.
common::ImageRgb8 composite(const Layers& layers, const common::ImageRgb8& camera_image);

}  // namespace amalgam::reference
