#include "server/server_options.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <stdexcept>

#include "common/build_info.h"
#include "common/parse_command_line.h"
#include "common/token_file.h"
#include "frame/rendering_threads.h"
#include "net/token.h"
#include "server/renderer_options.h"

namespace amalgam {
namespace {

// A time-out in seconds, above 0 and up to an hour.
void add_seconds(CLI::App& app, const std::string& name, std::chrono::milliseconds& value,
                 const std::string& what) {
  const auto set = [&value](double seconds) {
    value = std::chrono::milliseconds(std::lround(seconds * 1000.0));
  };
  app.add_option_function<double>(name, set, what)
      ->default_str(CLI::detail::to_string(static_cast<double>(value.count()) / 1000.0))
      ->type_name("SECONDS")
      ->check(CLI::Range(0.001, 3600.0));
}

void add_count(CLI::App& app, const std::string& name, std::size_t& value,
               const std::string& what) {
  app.add_option(name, value, what)
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(1, 65536));
}

void add_net_options(CLI::App& app, net::ServerConfig& net) {
  add_seconds(app, "--hello-timeout", net.session.hello_timeout, "for a client to say hello");
  add_seconds(app, "--message-timeout", net.session.message_timeout,
              "for a message once begun to be complete");
  add_seconds(app, "--ping-interval", net.session.ping_interval, "between pings to a client");
  add_seconds(app, "--idle-timeout", net.session.idle_timeout,
              "without a sign of life before a client is closed");
  add_seconds(app, "--write-timeout", net.session.write_timeout,
              "for a client to take a message before it is evicted");
  add_seconds(app, "--drain-timeout", net.drain_timeout,
              "at most, to finish frames in flight after SIGTERM");
  add_count(app, "--max-connections", net.connections.total, "clients in all");
  add_count(app, "--max-unauthenticated", net.connections.unauthenticated,
            "clients that have not said hello yet");
  add_count(app, "--max-per-address", net.connections.per_address, "clients from one address");
  add_count(app, "--max-admin", net.connections.admin, "connections to the admin port");
}

}  // namespace

std::optional<ServerOptions> parse_server_options(int argc, const char* const* argv) {
  ServerOptions options;
  options.scene = tools::default_scene_path();
  std::string listen = to_string(options.net.listen);
  std::string admin = to_string(options.net.admin);
  std::string token_file;

  CLI::App app("Renders virtual objects into the camera frames of its clients.", "amalgam-server");
  app.set_version_flag("--version", [] {
    return common::version_line("amalgam-server") + "; " + frame::ray_tracer_version();
  });
  app.set_config("--config", "", "file with these options, as 'threads = 4' (TOML or INI)");
  app.add_option("--scene", options.scene, "glTF scene to serve")
      ->capture_default_str()
      ->type_name("FILE");
  app.add_option("--listen", listen, "where clients connect; port 0 takes a free one")
      ->capture_default_str()
      ->type_name("ADDRESS:PORT");
  app.add_option("--admin", admin, "where /livez /readyz /metrics /state are; port 0 as above")
      ->capture_default_str()
      ->type_name("ADDRESS:PORT");
  app.add_option("--token-file", token_file,
                 "file with the secret that clients must send; without it they need none")
      ->type_name("FILE");
  tools::add_renderer_options(app, options.render.renderer);
  app.add_option("--quality", options.render.renderer.jpeg_quality,
                 "JPEG quality, 1 to 100, of composites for clients that leave it to the server, "
                 "where they "
                 "cannot take over the quality and the unchanged blocks of the camera's JPEG")
      ->capture_default_str()
      ->type_name("Q")
      ->check(CLI::Range(1, 100));
  app.add_option("--log-level", options.log_level, "how much is logged to standard error")
      ->capture_default_str()
      ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}));
  add_net_options(app, options.net);

  if (!common::parse_command_line(app, argc, argv)) return std::nullopt;
  options.net.listen = common::parse_host_port(listen);
  options.net.admin = common::parse_host_port(admin);
  options.net.ray_tracer = frame::ray_tracer_version();
  if (!token_file.empty())
    options.net.token = common::read_token_file(token_file, protocol::kMaxTokenBytes);
  return options;
}

}  // namespace amalgam
