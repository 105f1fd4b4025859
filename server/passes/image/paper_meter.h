// Automatic exposure and white balance by the paper of the markers.
//
// A desk's true color is unknown: a dark desk in bright light looks like a bright one in dim light,
// and a red one in white light like a white one in red light. But each frame shows at least one
// marker, printed in black on white paper, at a known place and under the light that the real
// surface below it has. So the exposure of each channel is
//   e = TM^-1(paper) / (kPaper W),
// W the radiance of a white Lambertian surface there (MeterGrid::white). Whatever color the desk
// has, it does not count.
//
// Ink and paper also tell which curve the camera has: the one by which their radiance differs as
// their reflectance does.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "common/camera_model.h"
#include "common/image.h"
#include "common/pose.h"
#include "passes/image/meter_grid.h"
#include "scene/light/tone_map.h"

namespace amalgam::passes {

// Reflectance of office paper, and of toner and black ink. Both vary: paper from 0.75 to 0.85, ink
// from 0.03 to 0.06.
inline constexpr float kPaper = 0.8f, kInk = 0.045f;
// Lamps and daylight differ by less than this from channel to channel. A larger factor to green's
// comes from something else, such as colored paper, and is not followed.
inline constexpr float kMostBalance = 3.0f;

struct SeenMarkers {
  std::span<const common::MarkerPose> poses;  // camera_from_marker; unusable ones are ignored
  double length = 0.05;                       // metres, side of the black square
};

// What a frame's markers show, in display-linear light.
struct PaperSample {
  glm::vec3 ink{0.0f}, paper{0.0f};
  glm::vec3 white{0.0f};  // W
};

// Markers that are small, cut off by the image's border or without a modelled real surface below
// them do not count, nor what is not black on white.
std::vector<PaperSample> sample_paper(const MeterGrid& grid, const SeenMarkers& markers,
                                      const common::CameraModel& ideal,
                                      const common::CameraModel& camera,
                                      const common::ImageRgb8& image);

// The exposure of each channel, the median over the markers; nothing without markers. Where the
// camera clips the paper, its ink is measured instead, without white balance.
std::optional<glm::vec3> meter_paper(std::span<const PaperSample> samples, scene::ToneCurve curve);

// How much better Linear explains the markers' contrast than Reinhard does: the difference of the
// two errors, in natural logarithms, in the median over the markers. Nothing if there is none, or
// if the camera cannot be judged, because it shows paper or ink too dark. Clipped paper beside ink
// that is too dark speaks for Linear.
std::optional<float> evidence_for_linear(std::span<const PaperSample> samples);

}  // namespace amalgam::passes
