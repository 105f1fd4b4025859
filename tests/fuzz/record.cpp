// A recorded session's file, as somebody attaches it to a report: refused with one line, or a
// session whose turns are of frames and lights that it has.
#include <stdexcept>

#include "client/tools/load/recorded_session.h"
#include "common/log.h"
#include "fuzz/scratch_file.h"
#include "fuzz/target.h"

namespace amalgam::fuzz {
namespace {

void check_turn(const load::RecordedSession& session, const load::RecordedSession::Turn& turn) {
  AMALGAM_CHECK(turn.frame < session.frames.size(), "a frame that never came");
  AMALGAM_CHECK(!turn.light || *turn.light < session.lights.size(), "a light that never shone");
}

}  // namespace
}  // namespace amalgam::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amalgam;
  static const fuzz::ScratchFile file("a.session");
  try {
    const load::RecordedSession session =
        load::read_recorded_session(file.write(fuzz::as_text(data, size)));
    for (const load::RecordedSession::Turn& turn : session.turns) {
      fuzz::check_turn(session, turn);
      AMALGAM_CHECK(session.frames[turn.frame].rendered.has_value(), "a turn without a result");
    }
    if (session.unfinished) fuzz::check_turn(session, *session.unfinished);
  } catch (const std::runtime_error&) {
  }
  return 0;
}
