// The three layers of the composite, which merge by adding (eq. 4.1, 4.2) and go onto the camera
// image as
//   I_f = A + (1 - a) I_c + D.
//
// Eq. 4.5 evaluated per sample in display-linear light and averaged over a pixel's samples; so a
// pixel that a virtual object covers by half is half that object and half the camera image, without
// a rim.
#pragma once

#include "core/image.h"

namespace amalgam::core {

struct Layers {
  ImageRgba32f over;       // A = mean(M_v (TM(I_m) + I_e)), premultiplied; alpha: a = mean(M_v)
  ImageRgb32f difference;  // D = mean((1 - M_v) (TM(I_m) - TM(I_r))), signed
};

}  // namespace amalgam::core
