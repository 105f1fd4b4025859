// A client, the renderer and the line in any order of events.
#include <algorithm>

#include "fuzz/scripted_line.h"
#include "fuzz/target.h"
#include "protocol/protobuf_log.h"

namespace amalgam::fuzz {
namespace {

net::ServerConfig make_config() {
  common::set_log_level("error");
  protocol::take_over_protobuf_log();
  net::ServerConfig config;
  config.session.environments_per_second = 1e6;  // by itself the clock would change what happens
  config.grants = {{"a", {.view = true, .environment = true}},
                   {"b", {.view = true, .environment = false}}};
  return config;
}

frame::FrameResult rendered(bool good, bool bad_image) {
  using Failure = frame::FrameFailure;
  if (!good) return Failure{bad_image ? Failure::Kind::BadImage : Failure::Kind::Internal, "bad"};
  frame::FrameOutput output;
  output.jpeg.resize(3);
  output.statistics.passes = {{"warp", false, "no lens distortion"}};
  return output;
}

// The lowest three bits of a byte say what happens, the next ones how.
void play(std::span<const std::byte> script, ScriptedLine& line) {
  while (!script.empty()) {
    const int event = std::to_integer<int>(script[0]);
    script = script.subspan(1);
    const bool good = (event & 8) == 0;
    switch (event & 7) {
      case 0: {  // a message: its length, then its bytes
        if (script.empty()) return;
        const auto length = std::min(std::to_integer<std::size_t>(script[0]), script.size() - 1);
        line.receive(script.subspan(1, length));
        script = script.subspan(1 + length);
        break;
      }
      case 1:
        line.finish_frame(rendered(good, (event & 16) != 0));
        break;
      case 2:
        line.finish_environment(good);
        break;
      case 3:
        line.run_step();
        break;
      case 4:
        line.write();
        break;
      case 5:
        line.drain();
        break;
      case 6:
        line.end();
        break;
      case 7:  // what mostly follows a frame: it is rendered, and its composite read
        line.finish_frame(rendered(true, false));
        line.run_step();
        line.write();
        break;
    }
    line.check_frames();
  }
}

}  // namespace
}  // namespace amalgam::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const amalgam::net::ServerConfig config = amalgam::fuzz::make_config();
  // Counts for all runs: making it costs more than a run.
  static amalgam::net::Metrics metrics;
  amalgam::fuzz::ScriptedLine line(config, metrics);
  amalgam::fuzz::play(amalgam::fuzz::as_bytes(data, size), line);
  return 0;
}
