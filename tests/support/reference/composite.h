// From samples to the picture: the layers of a pixel, and how they go onto the camera image
// (eq. 4.5, evaluated per sample).
#pragma once

#include "common/camera_model.h"
#include "common/image.h"
#include "support/reference/color_curves.h"
#include "support/reference/whitted.h"

namespace amalgam::reference {

struct Layers {
  common::Image<Vec4> over;         // A = mean(M_v (TM(I_m) + I_e)); alpha: a = mean(M_v)
  common::Image<Color> difference;  // D = mean((1 - M_v) (TM(I_m) - TM(I_r)))
  common::Image<Color> relative;    // Q = mean((1 - M_v) (I_m / I_r - 1)), real diffuse surfaces

  static Layers zero(int width, int height);
};

// Adds one sample's share to a pixel; weight: 1 over the number of samples.
void add_sample(Layers& layers, int x, int y, const Sample& sample, const Response& response,
                bool by_ratio, double weight);

// The layers as the distorted camera sees them: bilinear, 0 outside the ideal image. The ideal
// camera is the one that the layers were rendered with.
Layers warp(const Layers& layers, const common::CameraModel& camera,
            const common::CameraModel& ideal);

// I_f = A + (1 - a) TM(TM^-1(I_c) q) + D with q = 1 + Q / (1 - a), display-linear. All of the
// camera image's size.
Color composite_color(const Layers& layers, const common::ImageRgb8& camera_image, int x, int y,
                      const Response& response);
// sRGB-encoded and rounded.
common::ImageRgb8 composite(const Layers& layers, const common::ImageRgb8& camera_image,
                            const Response& response);

}  // namespace amalgam::reference
