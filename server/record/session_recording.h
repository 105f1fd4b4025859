// One session's record: makes records of what was said and done, and hands them to the writer. On
// the network's thread. Nothing here throws; where memory is missing the record ends.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "common/pose.h"
#include "protocol/session_record.pb.h"
#include "record/track.h"

namespace amalgam::record {

class Recorder;

class SessionRecording {
 public:
  // recorder: null where there is none. Nothing is recorded before begin().
  explicit SessionRecording(Recorder* recorder) : recorder_(recorder) {}
  ~SessionRecording();
  SessionRecording(const SessionRecording&) = delete;
  SessionRecording& operator=(const SessionRecording&) = delete;

  // The hello was accepted. Records nothing if the operator does not want records. Hellos may have
  // their token, which is never written.
  void begin(std::uint64_t session, const protocol::Hello& hello,
             const protocol::Fingerprint& fingerprint);

  // From the client. Frames and environments get numbers from 1, as they come.
  void received(const protocol::Envelope& envelope);
  void received_refused_frame();  // that nobody read
  // To the client: anything but a composite.
  void sent(const protocol::Envelope& envelope);
  // frame: its number. composite: makes it, with its JPEG; called only if there is a record.
  void submitted(std::uint64_t frame, std::span<const common::MarkerPose> poses);
  void rendered(std::uint64_t frame, const std::function<protocol::Composite()>& composite);
  void failed(std::uint64_t frame, const protocol::Error& error);
  void written();  // the composite rendered last

  // The environment received last goes to the renderer: at once, or when the one before is done.
  void environment_accepted();
  // The renderer is done with the oldest of those.
  void environment_done(bool applied);
  void lit_by_another(const protocol::Environment& light);

  void end(Fate fate);

  bool is_on() const { return track_ && track_->fate == Fate::On; }
  Fate fate() const { return track_ ? track_->fate.load() : Fate::Off; }
  std::uint64_t bytes() const { return track_ ? track_->bytes.load() : 0; }

 private:
  // An environment on its way. The message is kept if it is to light others too.
  struct Light {
    std::uint64_t number = 0;
    std::shared_ptr<const protocol::Environment> for_all;
  };

  // Fills a record of now and hands it over.
  template <typename Fill>
  void record(Fill fill);
  void keep_for_all(const protocol::Environment& environment);

  Recorder* recorder_;
  std::shared_ptr<Track> track_;
  std::uint64_t frames_ = 0, environments_ = 0;  // received
  std::uint64_t last_rendered_ = 0;
  std::shared_ptr<const protocol::Environment> received_for_all_;  // the last one
  // As in net/environment_slot.h: one is applied and one waits.
  std::optional<Light> applying_, waiting_;
};

}  // namespace amalgam::record
