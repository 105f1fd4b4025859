// The server's metrics, for Prometheus. May be used from any thread.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include "frame/frame.h"
#include "protocol/amalgam.pb.h"
#include "record/record_writer.h"

namespace amalgam::net {

// Why a received frame was never answered by a composite.
enum class Skip {
  ReplacedBeforeRender,  // by a newer frame while it waited
  ReplacedBeforeWrite,   // by a newer composite while its own waited
  Refused,               // answered by an Error
  Draining,
  Closed,  // the session ended first
};
inline constexpr std::array kSkips{Skip::ReplacedBeforeRender, Skip::ReplacedBeforeWrite,
                                   Skip::Refused, Skip::Draining, Skip::Closed};
const char* to_string(Skip reason);  // as a label

// What became of an environment that a client sent.
enum class EnvironmentFate { Applied, Replaced, Unusable, Forbidden, TooOften, NoMemory };

// What is not counted but looked at, when somebody asks for the metrics.
struct Gauges {
  std::size_t connections = 0, unauthenticated = 0;
  std::uint64_t session_memory = 0;  // bytes promised to sessions
  frame::ServiceLoad load;
  std::uint64_t dropped_log_lines = 0;
  record::WriterCounts records;
};

class Metrics {
 public:
  Metrics();
  ~Metrics();

  void connected(const std::string& transport);
  void session_opened();
  void session_closed();
  void refused(const std::string& reason);  // a connection or session that was not served
  void error_sent(protocol::Error::Code code);
  void capture_time_clamped();
  void pose_held_or_dropped(std::size_t count);

  void frame_received(std::size_t message_bytes);
  void frame_skipped(Skip reason, std::size_t count = 1);
  // server_ms: from the last byte of the frame to its composite, waiting included.
  void frame_rendered(const frame::FrameOutput& output, double server_ms);
  void composite_sent(std::size_t message_bytes);

  void environment(EnvironmentFate fate);
  void reloaded(bool good);

  // Prometheus' text format.
  std::string text(const Gauges& gauges);

 private:
  struct Families;
  std::unique_ptr<Families> families_;
};

}  // namespace amalgam::net
