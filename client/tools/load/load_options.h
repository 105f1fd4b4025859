// The command line of amalgam-load.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "net/server_config.h"
#include "protocol/stream.h"

namespace amalgam::load {

enum class Fault {
  None,
  BadPose,   // every pose is NaN
  BadImage,  // every image is garbage
  Cut,       // the connection ends in the middle of the last frame
};

struct LoadOptions {
  common::HostPort server;
  int clients = 1;
  double rate = 30.0;        // frames a second, for each client
  std::uint64_t frames = 0;  // for each client; 0: until the duration is over
  std::chrono::milliseconds duration{10000};
  std::string image;  // a JPEG file; empty: mid grey, 640 x 480
  std::string token;
  protocol::Stream::Tls tls;  // null: not encrypted
  int sources = 0;  // addresses 127.0.x.y that clients come from in turn; 0: the kernel's choice
  bool moving = false;  // the marker, so that no frame is like the last one
  Fault fault = Fault::None;
};

// Nothing after --help. Throws std::runtime_error or std::invalid_argument.
std::optional<LoadOptions> parse_load_options(int argc, const char* const* argv);

}  // namespace amalgam::load
