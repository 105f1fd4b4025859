// amalgam-client --calibrate: watches a board and writes the lens.
#pragma once

#include <atomic>

#include "client/options.h"
#include "client/sinks/frame_sink.h"
#include "client/sources/camera_source.h"

namespace amalgam::client {

// Takes pictures until there are enough, the source ends or the user stops it; then writes
// options.calibrate. Says on standard error how far it is. sink may be null; it shows the pictures
// with the corners found in them. Throws std::runtime_error if the pictures do not determine the
// lens; then nothing is written.
void calibrate(const Options& options, CameraSource& source, FrameSink* sink,
               const std::atomic<bool>& stop);

}  // namespace amalgam::client
