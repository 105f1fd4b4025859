// The command line of amalgam-server: every option with its unit and default.
#pragma once

#include <optional>
#include <string>

#include "frame/render_thread.h"
#include "net/server_config.h"

namespace amalgam {

struct ServerOptions {
  std::string scene;  // path of a glTF file
  std::string log_level = "info";
  std::string log_format = "text";
  net::ServerConfig net;
  frame::RenderServiceOptions render;
};

// Nothing if the program should end, as after --help. Throws std::runtime_error or
// std::invalid_argument with one line.
std::optional<ServerOptions> parse_server_options(int argc, const char* const* argv);

}  // namespace amalgam
