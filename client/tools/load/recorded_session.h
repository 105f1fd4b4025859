// A recorded session as it is played again: what came and when, and what decided each composite.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "protocol/session_record.pb.h"

namespace amalgam::load {

struct RecordedFrame {
  std::uint64_t number = 0;           // among the session's frames, from 1
  std::chrono::microseconds time{0};  // of its arrival, since the session began
  protocol::CameraFrame message;      // as it came
  // With the poses that it was rendered with; none: the renderer was never given it.
  std::optional<protocol::SubmittedFrame> submitted;
  std::optional<protocol::RenderedFrame> rendered;  // none: a newer one took its place, or the end

  // What the renderer was given: solved and held ones are poses like any other.
  const google::protobuf::RepeatedPtrField<protocol::Pose>& poses() const {
    return submitted ? submitted->poses() : message.poses();
  }
  // The frame with those, and without corners.
  protocol::CameraFrame as_submitted() const;
  // The composite's JPEG; null if it got none.
  const std::string* jpeg() const;
};

struct RecordedLight {
  std::chrono::microseconds time{0};  // of its arrival
  // For the session alone, even if it was for all: nobody else is to be lit by a replay, and
  // whoever may have a session may light it.
  protocol::Environment environment;
};

struct RecordedSession {
  protocol::RecordHeader header;
  std::vector<RecordedFrame> frames;  // by arrival
  std::vector<RecordedLight> lights;  // that took effect

  // What the renderer did, in its order.
  struct Turn {
    std::optional<std::size_t> light;  // index of the one that this frame was the first to have
    std::size_t frame = 0;             // index
  };
  std::vector<Turn> turns;
  // What was being rendered when the record broke off, as by a crash.
  std::optional<Turn> unfinished;

  std::string end;  // how the record ended: "closed", "full", "too_slow", "reloaded" or "cut"
};

// Throws std::runtime_error.
RecordedSession read_recorded_session(const std::filesystem::path& path);

}  // namespace amalgam::load
