// Between the messages of the protocol and the types of the renderer. What comes from the wire is
// checked here; ClientError says what was wrong.
#pragma once

#include <string_view>
#include <vector>

#include "core/pose.h"
#include "frame/frame.h"
#include "net/client_error.h"
#include "net/server_config.h"
#include "protocol/amalgam.pb.h"

namespace amalgam::net {

// Size, camera and quality of a Hello (its version and token are the session's to check).
// Throws ClientError(BAD_HELLO).
frame::ViewOptions view_options_from(const protocol::Hello& hello);

// As sent, usable or not.
std::vector<core::MarkerPose> poses_from(const protocol::CameraFrame& frame);

frame::Bytes bytes_from(std::string_view bytes);

protocol::Envelope welcome_message(std::uint64_t session, const SessionLimits& limits,
                                   const frame::FrameService::MarkerSet& markers);
protocol::Envelope error_message(const ClientError& error);

// All but what the session knows: ids, times, poses and skipped frames.
protocol::Composite composite_from(const frame::FrameOutput& output);

protocol::Pose pose_to_wire(const core::MarkerPose& pose);

}  // namespace amalgam::net
