// What Amalgam does for one row of Table 6.1.
#pragma once

#include "bench/thesis_table.h"

namespace amalgam::bench {

struct ThesisResult {
  ThesisRow row;
  double frames_per_second = 0.0;
  // The row's super-sampling was done by adaptive sampling, because its error is no larger.
  bool adaptive = false;
  // Mean difference to many samples a pixel, in 1/255. That of the fixed samples too, where
  // adaptive ones were tried.
  double error = 0.0;
  double fixed_error = 0.0;

  double ratio() const { return frames_per_second / row.frames_per_second; }
};

}  // namespace amalgam::bench
