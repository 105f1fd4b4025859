// Makes the client's protocol messages.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string>

#include "common/camera_model.h"
#include "common/pose.h"
#include "protocol/amalgam.pb.h"

namespace amalgam::client {

// jpeg_quality of the composites: 1..100, 0 for the server's default.
protocol::Hello hello_message(const common::CameraModel& camera, const std::string& token,
                              int jpeg_quality);

// Poses beyond the protocol's limit for one frame are dropped from the end.
protocol::Envelope frame_message(std::uint64_t frame_id, std::span<const unsigned char> jpeg,
                                 std::chrono::steady_clock::time_point captured_at,
                                 std::span<const common::MarkerPose> poses);

}  // namespace amalgam::client
