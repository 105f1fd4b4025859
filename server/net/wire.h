// Converts between protocol messages and the renderer's types. Checks messages from the wire; a
// ClientError says what is wrong.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/pose.h"
#include "frame/frame.h"
#include "net/answer.h"
#include "net/client_error.h"
#include "net/server_config.h"
#include "protocol/amalgam.pb.h"

namespace amalgam::net {

// Checks version and token of a Hello, and tells what the client may do. Throws
// ClientError(UNSUPPORTED_VERSION or AUTH_FAILED).
Rights check_admission(const protocol::Hello& hello, const std::vector<Grant>& grants);

// Size, camera and quality of a Hello.
// Throws ClientError(BAD_HELLO).
frame::ViewOptions view_options_from(const protocol::Hello& hello);

// As sent, usable or not.
std::vector<common::MarkerPose> poses_from(const protocol::CameraFrame& frame);

// Throws ClientError(BAD_ENVIRONMENT) for a missing image or an unusable fish-eye lens. The
// renderer checks the image itself.
frame::EnvironmentInput environment_from(const protocol::Environment& environment);

frame::Bytes bytes_from(std::string_view bytes);

protocol::Envelope welcome_message(std::uint64_t session, const SessionLimits& limits,
                                   const frame::FrameService::MarkerSet& markers,
                                   const protocol::Fingerprint& fingerprint);
// Of this build of the server and its renderer.
protocol::Fingerprint fingerprint_message(const frame::FrameService::Fingerprint& renderer);
protocol::Envelope ping_message(std::uint64_t nonce);
protocol::Envelope pong_message(std::uint64_t nonce);
protocol::Envelope busy_message(std::chrono::milliseconds retry_after, const std::string& reason);
protocol::Envelope draining_message(std::chrono::milliseconds deadline);
protocol::Envelope error_message(const ClientError& error);

// The error of a frame with unusable poses of these markers.
ClientError poses_rejected(const std::vector<int>& markers, std::uint64_t frame_id);

// skipped: frames of the session that will never be answered, so far.
protocol::Envelope composite_message(const Answer& answer, std::uint64_t skipped);

}  // namespace amalgam::net
