// The command line of amalgam-load.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "common/host_port.h"
#include "protocol/stream.h"

namespace amalgam::load {

enum class Fault {
  None,
  BadPose,    // every pose is NaN
  BadImage,   // every image is garbage
  Cut,        // the connection ends in the middle of the last frame
  Garbage,    // random bytes after the hello
  HalfOpen,   // connects and says nothing
  HelloOnly,  // leaves when it is welcomed
  WrongToken,
  SlowReader,    // reads nothing after the welcome
  Environments,  // one with each frame, by turns for all and for itself
};

struct LoadOptions {
  common::HostPort server;
  int clients = 1;
  double rate = 30.0;        // frames a second, for each client
  std::uint64_t frames = 0;  // for each client; 0: until the duration is over
  std::chrono::milliseconds duration{10000};
  // Clients a second that arrive, whether others have left or not; 0: all are there at the start.
  double arrivals = 0.0;
  std::chrono::milliseconds stay{0};  // of a client that arrives; 0: to the end
  std::string image;                  // a JPEG file; empty: mid grey
  int width = 640, height = 480;      // of mid grey, pixels
  std::string token;
  protocol::Stream::Tls tls;  // null: not encrypted
  std::string latencies;      // a CSV file for the latency of each frame that was due
  int first_source = 1;       // the last number of the first of
  int sources = 0;  // addresses 127.0.x.y that clients come from in turn; 0: the kernel's choice
  bool moving = false;  // the marker, so that no frame is like the last one
  Fault fault = Fault::None;
  std::string replay;  // a recorded session's file, to be played instead of all that
  bool as_fast_as_possible = false;
  std::string output;  // a folder for the JPEGs of frames that differ; empty: nowhere
};

// Nothing after --help. Throws std::runtime_error or std::invalid_argument.
std::optional<LoadOptions> parse_load_options(int argc, const char* const* argv);

}  // namespace amalgam::load
