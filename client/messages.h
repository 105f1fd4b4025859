// The client's words for the messages of the protocol.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "client/camera_source.h"
#include "core/camera_model.h"
#include "core/pose.h"
#include "protocol/amalgam.pb.h"

namespace amalgam::client {

// jpeg_quality of the composites: 1..100, 0 for the server's default.
protocol::Hello hello_message(const core::CameraModel& camera, const std::string& token,
                              int jpeg_quality);

// Poses beyond what the protocol allows in one frame are left out, the last ones first.
protocol::Envelope frame_message(std::uint64_t frame_id, const CapturedFrame& frame,
                                 std::span<const core::MarkerPose> poses);

}  // namespace amalgam::client
