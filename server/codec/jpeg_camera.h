// The contents of JpegCoefficients. For this folder only.
#pragma once

#include <memory>

#include "codec/jpeg.h"
#include "codec/jpeg_mcus.h"
#include "codec/jpeg_segments.h"
#include "codec/libjpeg.h"

namespace amalgam::codec {

struct CameraJpeg {
  JpegHeader header;
  std::unique_ptr<CoefficientReader> reader;
  McuGrid grid;
  SegmentedJpeg segments;  // the whole picture
  std::vector<std::byte> metadata;
};

}  // namespace amalgam::codec
