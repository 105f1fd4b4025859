// A desk with something of each kind on it, of any size, and how its picture is judged.
#pragma once

#include <string>

#include "parity/parity_case.h"
#include "parity/rendering.h"

namespace amalgam::extreme {

inline constexpr int kDeskWidth = 48, kDeskHeight = 36;
// Of the glass ball, for a desk of size 1. A bubble is in its middle.
inline constexpr glm::dvec3 kGlassMiddle{-0.16, 0.15, 0.05};
inline constexpr double kGlassRadius = 0.12, kBubbleRadius = 0.05;

// A real floor and block; a virtual block, mirror and glass ball; a lamp and a soft environment.
// size: metres from one end to the other.
parity::ParityCase make_desk(double size = 1.0);

// Moves the camera of a desk of that size; lengths are for size 1.
void place_camera(parity::ParityCase& desk, double size, const glm::dvec3& eye,
                  const glm::dvec3& target);
// Replaces it; the camera image becomes one of its size.
void set_camera(parity::ParityCase& desk, const common::CameraModel& camera);

parity::Rendering render(const parity::ParityCase& desk, frame::RendererMode mode);

// Traced and hybrid agree with the reference, and no value had to be replaced.
void expect_right(const parity::ParityCase& desk);
// The same with a reference picture made otherwise, with grazing pixels found.
void expect_close(const parity::ParityCase& desk, const reference::ReferenceImages& expected);
// Traced and hybrid agree with each other, where the reference has no answer or takes too long.
void expect_both_alike(const parity::ParityCase& desk);

}  // namespace amalgam::extreme
