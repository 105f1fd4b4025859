// A configuration file: refused with one line, or options within their ranges.
#include <stdexcept>

#include "common/log.h"
#include "frame/renderer_settings.h"
#include "fuzz/scratch_file.h"
#include "fuzz/target.h"
#include "server/server_options.h"

namespace amalgam::fuzz {
namespace {

void check(const ServerOptions& options) {
  frame::check_settings(options.render.renderer);
  const int quality = options.render.renderer.jpeg_quality;
  AMALGAM_CHECK(quality >= 1 && quality <= 100, std::to_string(quality));
  const net::SessionLimits& session = options.net.session;
  for (const auto time : {session.hello_timeout, session.message_timeout, session.ping_interval,
                          session.idle_timeout, session.write_timeout, options.net.drain_timeout,
                          options.net.stuck_after, options.net.stuck_reload_after}) {
    AMALGAM_CHECK(time.count() >= 1 && time <= std::chrono::hours(1), std::to_string(time.count()));
  }
  const net::ConnectionCaps& caps = options.net.connections;
  for (const std::size_t count : {caps.total, caps.unauthenticated, caps.per_address, caps.admin}) {
    AMALGAM_CHECK(count >= 1 && count <= 65536, std::to_string(count));
  }
}

}  // namespace
}  // namespace amalgam::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amalgam;
  static const fuzz::ScratchFile file("server.toml");
  file.write(fuzz::as_text(data, size));
  const std::string path = file.path().string();
  const char* const arguments[] = {"amalgam-server", "--config", path.c_str()};
  try {
    if (const auto options = parse_server_options(3, arguments)) fuzz::check(*options);
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
