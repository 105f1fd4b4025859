// Makes the client's protocol messages.
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

// Poses beyond the protocol's limit for one frame are dropped from the end.
protocol::Envelope frame_message(std::uint64_t frame_id, const CapturedFrame& frame,
                                 std::span<const common::MarkerPose> poses);

}  // namespace amalgam::client
