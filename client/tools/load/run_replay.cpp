#include "client/tools/load/run_replay.h"

#include <boost/asio/io_context.hpp>
#include <memory>

#include "client/tools/load/fast_replay.h"
#include "client/tools/load/timed_replay.h"

namespace amalgam::load {

ReplayOutcome run_replay(const LoadOptions& options) {
  const RecordedSession session = read_recorded_session(options.replay);
  ReplayComparison comparison(session, options.output);
  boost::asio::io_context io(1);
  std::unique_ptr<Replay> replay;
  if (options.as_fast_as_possible) {
    replay = std::make_unique<FastReplay>(io, options, session, comparison);
  } else {
    replay = std::make_unique<TimedReplay>(io, options, session, comparison);
  }
  replay->start();
  io.run();
  return {comparison.is_good(options.as_fast_as_possible), comparison.to_json()};
}

}  // namespace amalgam::load
