// The server's metrics, for Prometheus. May be used from any thread.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "frame/frame.h"
#include "protocol/amalgam.pb.h"

namespace amalgam::net {

// Why a received frame was never answered by a composite.
enum class Skip {
  ReplacedBeforeRender,  // by a newer frame while it waited
  ReplacedBeforeWrite,   // by a newer composite while its own waited
  Refused,               // answered by an Error
  Draining,
  Closed,  // the session ended first
};

class Metrics {
 public:
  Metrics();
  ~Metrics();

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

  // Prometheus' text format.
  std::string text() const;

 private:
  struct Families;
  std::unique_ptr<Families> families_;
};

}  // namespace amalgam::net
