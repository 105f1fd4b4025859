// What Amalgam does for one row of Table 6.1.
#pragma once

#include <optional>

#include "bench/thesis_table.h"

namespace amalgam::bench {

struct ThesisResult {
  ThesisRow row;
  double frames_per_second = 0.0;
  // The row's super-sampling was done by adaptive sampling, because that was faster and its error
  // no larger.
  bool adaptive = false;
  double error = 0.0;  // mean difference to many samples a pixel, in 1/255
  // That of adaptive samples, for rows of more than one.
  std::optional<double> adaptive_error{};

  // With the row's fixed samples, once nothing moves any more; none if they are too many to be
  // kept.
  std::optional<double> still_frames_per_second{};

  double ratio() const { return frames_per_second / row.frames_per_second; }
};

}  // namespace amalgam::bench
