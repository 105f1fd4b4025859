#include "record/recorder.h"

#include <utility>

#include "record/session_recording.h"

namespace amalgam::record {

void Recorder::begin(SessionRecording& recording) {
  recordings_.insert(&recording);
  if (light_) recording.lit_by_another(*light_);
}

void Recorder::reloaded(RecordOptions options) {
  for (SessionRecording* const recording : recordings_) recording->end(Fate::Reloaded);
  options_ = std::move(options);
  light_.reset();  // the scene's own shines again
}

void Recorder::lit(const SessionRecording* by, std::shared_ptr<const protocol::Environment> light) {
  light_ = std::move(light);
  for (SessionRecording* const recording : recordings_) {
    if (recording != by) recording->lit_by_another(*light_);
  }
}

}  // namespace amalgam::record
