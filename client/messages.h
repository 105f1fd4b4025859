// The client's words for the messages of the protocol.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "client/camera_source.h"
#include "common/camera_model.h"
#include "common/pose.h"
#include "protocol/amalgam.pb.h"

namespace amalgam::client {

// jpeg_quality of the composites: 1..100, 0 for the server's default.
protocol::Hello hello_message(const common::CameraModel& camera, const std::string& token,
                              int jpeg_quality);

// Poses beyond what the protocol allows in one frame are left out, the last ones first.
protocol::Envelope frame_message(std::uint64_t frame_id, const CapturedFrame& frame,
                                 std::span<const common::MarkerPose> poses);

}  // namespace amalgam::client
