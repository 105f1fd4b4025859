#include "client/tools/load/recorded_session.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <stdexcept>
#include <utility>

#include "protocol/session_record.h"

namespace amalgam::load {
namespace {

using std::chrono::microseconds;

class Builder {
 public:
  explicit Builder(RecordedSession& session) : session_(session) {}

  void add(protocol::SessionRecord record) {
    const microseconds time(record.time_us());
    switch (record.event_case()) {
      case protocol::SessionRecord::kReceived:
        return add_received(*record.mutable_received(), time);
      case protocol::SessionRecord::kSubmitted:
        return add_submitted(std::move(*record.mutable_submitted()));
      case protocol::SessionRecord::kRendered:
        return add_rendered(std::move(*record.mutable_rendered()));
      case protocol::SessionRecord::kLight:
        return add_light(*record.mutable_light(), time);
      case protocol::SessionRecord::kEnd:
        session_.end = protocol::RecordEnd::Reason_Name(record.end().reason());
        std::ranges::transform(session_.end, session_.end.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return;
      case protocol::SessionRecord::kHeader:
      case protocol::SessionRecord::kSent:
      case protocol::SessionRecord::kWritten:
      case protocol::SessionRecord::EVENT_NOT_SET:
        return;  // for people who read records; decides nothing
    }
  }

  void finish() {
    if (!session_.end.empty()) return;
    session_.end = "cut";
    if (in_renderer_)
      session_.unfinished = RecordedSession::Turn{new_light_, frame_of_.at(*in_renderer_)};
  }

 private:
  void add_received(protocol::ReceivedMessage& received, microseconds time) {
    protocol::Envelope& envelope = *received.mutable_envelope();
    if (envelope.has_camera_frame()) {
      frame_of_[received.number()] = session_.frames.size();
      session_.frames.push_back({.number = received.number(),
                                 .time = time,
                                 .message = std::move(*envelope.mutable_camera_frame()),
                                 .submitted = {},
                                 .rendered = {}});
    }
    if (envelope.has_environment()) {
      environments_[received.number()] = {time, std::move(*envelope.mutable_environment())};
    }
  }

  RecordedFrame& frame(std::uint64_t number) {
    const auto found = frame_of_.find(number);
    if (found == frame_of_.end()) {
      throw std::runtime_error("the record is damaged: frame " + std::to_string(number) +
                               " never came");
    }
    return session_.frames[found->second];
  }

  // Which frame the renderer has follows from what it returned: it takes the newest one that waits,
  // or the next that comes.
  void add_submitted(protocol::SubmittedFrame submitted) {
    last_submitted_ = submitted.frame();
    if (!in_renderer_) in_renderer_ = last_submitted_;
    frame(last_submitted_).submitted = std::move(submitted);
  }

  void add_rendered(protocol::RenderedFrame rendered) {
    const std::uint64_t number = rendered.frame();
    in_renderer_.reset();
    if (last_submitted_ > number) in_renderer_ = last_submitted_;
    frame(number).rendered = std::move(rendered);
    session_.turns.push_back({std::exchange(new_light_, std::nullopt), frame_of_.at(number)});
  }

  void add_light(protocol::LightChange& change, microseconds time) {
    RecordedLight light{time, {}};
    if (change.environment() == 0) {
      light.environment = std::move(*change.mutable_from_another());
    } else {
      const auto found = environments_.find(change.environment());
      if (found == environments_.end()) throw std::runtime_error("the record is damaged: no light");
      light = found->second;
    }
    // What is for all does not light a session that has its own.
    if (has_own_light_ && !light.environment.own()) return;
    has_own_light_ = light.environment.own();
    light.environment.set_own(true);
    new_light_ = session_.lights.size();
    session_.lights.push_back(std::move(light));
  }

  RecordedSession& session_;
  std::map<std::uint64_t, std::size_t> frame_of_;  // index by number
  std::map<std::uint64_t, RecordedLight> environments_;
  std::optional<std::size_t> new_light_;
  bool has_own_light_ = false;
  std::uint64_t last_submitted_ = 0;
  std::optional<std::uint64_t> in_renderer_;
};

}  // namespace

protocol::CameraFrame RecordedFrame::as_submitted() const {
  protocol::CameraFrame frame = message;
  if (!submitted) return frame;
  frame.clear_corners();
  *frame.mutable_poses() = submitted->poses();
  return frame;
}

const std::string* RecordedFrame::jpeg() const {
  if (!rendered || !rendered->has_composite()) return nullptr;
  return rendered->composite().unchanged() ? &message.jpeg() : &rendered->composite().jpeg();
}

RecordedSession read_recorded_session(const std::filesystem::path& path) {
  protocol::SessionRecordReader reader(path);
  RecordedSession session;
  session.header = reader.header();
  Builder builder(session);
  try {
    while (auto record = reader.next()) builder.add(std::move(*record));
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    throw std::runtime_error(what.starts_with(path.string()) ? what : path.string() + ": " + what);
  }
  builder.finish();
  return session;
}

}  // namespace amalgam::load
