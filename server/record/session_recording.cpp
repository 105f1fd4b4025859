#include "record/session_recording.h"

#include <exception>
#include <utility>

#include "protocol/framing.h"
#include "protocol/geometry.h"
#include "protocol/session_record.h"
#include "record/record_folder.h"
#include "record/recorder.h"

namespace amalgam::record {

using protocol::Envelope;
using protocol::SessionRecord;

SessionRecording::~SessionRecording() {
  end(Fate::Closed);
  if (recorder_ != nullptr) recorder_->recordings_.erase(this);
}

template <typename Fill>
void SessionRecording::record(Fill fill) {
  if (!is_on()) return;
  try {
    SessionRecord record = record_now(*track_);
    fill(record);
    recorder_->writer_.append(track_, protocol::encode(record));
  } catch (const std::exception&) {  // no memory, and no session ends because of its record
    end(Fate::Failed);
  }
}

void SessionRecording::end(Fate fate) {
  if (!track_) return;
  try {
    recorder_->writer_.end(track_, fate);
  } catch (const std::exception&) {
    track_->fate = Fate::Failed;
  }
}

void SessionRecording::begin(std::uint64_t session, const protocol::Hello& hello,
                             const protocol::Fingerprint& fingerprint) {
  if (recorder_ == nullptr || !recorder_->is_on()) return;
  try {
    track_ = std::make_shared<Track>(session, recorder_->options_);
    record([&](SessionRecord& record) {
      protocol::RecordHeader& header = *record.mutable_header();
      header.set_format(protocol::kRecordFormat);
      header.set_started(utc_now());
      header.set_session(session);
      *header.mutable_hello() = hello;
      header.mutable_hello()->clear_token();
      *header.mutable_fingerprint() = fingerprint;
    });
    recorder_->begin(*this);
  } catch (const std::exception&) {  // no memory
    end(Fate::Failed);
  }
}

void SessionRecording::received(const Envelope& envelope) {
  std::uint64_t number = 0;
  if (envelope.has_camera_frame()) number = ++frames_;
  if (envelope.has_environment()) {
    number = ++environments_;
    keep_for_all(envelope.environment());
  }
  record([&](SessionRecord& record) {
    protocol::ReceivedMessage& received = *record.mutable_received();
    received.set_number(number);
    *received.mutable_envelope() = envelope;
    // A second hello is an error, but it has a token all the same.
    if (envelope.has_hello()) received.mutable_envelope()->mutable_hello()->clear_token();
  });
}

void SessionRecording::received_refused_frame() {
  const std::uint64_t number = ++frames_;
  record([&](SessionRecord& record) { record.mutable_received()->set_number(number); });
}

void SessionRecording::sent(const Envelope& envelope) {
  record([&](SessionRecord& record) { *record.mutable_sent() = envelope; });
}

void SessionRecording::submitted(std::uint64_t frame, std::span<const common::MarkerPose> poses) {
  record([&](SessionRecord& record) {
    protocol::SubmittedFrame& submitted = *record.mutable_submitted();
    submitted.set_frame(frame);
    for (const common::MarkerPose& pose : poses) {
      *submitted.add_poses() = protocol::to_message(pose);
    }
  });
}

void SessionRecording::rendered(std::uint64_t frame,
                                const std::function<protocol::Composite()>& composite) {
  last_rendered_ = frame;
  record([&](SessionRecord& record) {
    protocol::RenderedFrame& rendered = *record.mutable_rendered();
    rendered.set_frame(frame);
    *rendered.mutable_composite() = composite();
    if (rendered.composite().unchanged()) rendered.mutable_composite()->clear_jpeg();
  });
}

void SessionRecording::failed(std::uint64_t frame, const protocol::Error& error) {
  record([&](SessionRecord& record) {
    record.mutable_rendered()->set_frame(frame);
    *record.mutable_rendered()->mutable_error() = error;
  });
}

void SessionRecording::written() {
  record([&](SessionRecord& record) { record.mutable_written()->set_frame(last_rendered_); });
}

// --- light ---

// What lights all sessions is in the records of the others too, whether this one has one or not.
void SessionRecording::keep_for_all(const protocol::Environment& environment) {
  received_for_all_.reset();
  if (recorder_ == nullptr || !recorder_->is_on() || environment.own()) return;
  try {
    received_for_all_ = std::make_shared<const protocol::Environment>(environment);
  } catch (const std::exception&) {  // no memory
    end(Fate::Failed);
  }
}

void SessionRecording::environment_accepted() {
  std::optional<Light>& place = applying_ ? waiting_ : applying_;
  place = Light{environments_, std::exchange(received_for_all_, nullptr)};
}

void SessionRecording::environment_done(bool applied) {
  if (!applying_) return;
  const Light done = *std::exchange(applying_, std::exchange(waiting_, std::nullopt));
  if (!applied) return;
  record([&](SessionRecord& record) { record.mutable_light()->set_environment(done.number); });
  if (done.for_all) recorder_->lit(this, done.for_all);
}

void SessionRecording::lit_by_another(const protocol::Environment& light) {
  record([&](SessionRecord& record) { *record.mutable_light()->mutable_from_another() = light; });
}

}  // namespace amalgam::record
