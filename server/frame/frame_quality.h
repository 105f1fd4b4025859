// The governor's choice for a frame, for its statistics.
#pragma once

namespace amalgam::frame {

// The quality of a frame of a view with a target frame rate (frame/governor.h).
struct FrameQuality {
  // What kept the quality from being better.
  enum class Bound { Nothing, Trace, Raster, Encode, Lowest };

  int level = 0;         // 0: as the operator set it
  int lowest_level = 0;  // the level with the least quality
  int samples_per_pixel = 1;
  bool adaptive = false;  // more samples where neighbours differ
  int max_depth = 0;
  float importance_cutoff = 0.0f;
  float render_scale = 1.0f;  // rendered pixels for each of the camera's, on each axis
  int jpeg_quality = 0;       // 1..100
  Bound bound = Bound::Nothing;
};

inline const char* to_string(FrameQuality::Bound bound) {
  switch (bound) {
    case FrameQuality::Bound::Nothing:
      return "nothing: full quality";
    case FrameQuality::Bound::Trace:
      return "trace";
    case FrameQuality::Bound::Raster:
      return "raster";
    case FrameQuality::Bound::Encode:
      return "encode";
    case FrameQuality::Bound::Lowest:
      return "at its lowest";
  }
  return "";
}

}  // namespace amalgam::frame
