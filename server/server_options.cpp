#include "server/server_options.h"

#include <CLI/CLI.hpp>
#include <boost/asio/ip/address.hpp>
#include <chrono>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "common/build_info.h"
#include "common/parse_command_line.h"
#include "frame/rendering_threads.h"
#include "net/address_key.h"
#include "server/printed_sheets.h"
#include "server/renderer_options.h"
#include "web/web_files.h"

namespace amalgam {
namespace {

// A time-out in seconds, up to an hour.
void add_seconds(CLI::App& app, const std::string& name, std::chrono::milliseconds& value,
                 const std::string& what, double least = 0.001) {
  const auto set = [&value](double seconds) {
    value = std::chrono::milliseconds(std::lround(seconds * 1000.0));
  };
  app.add_option_function<double>(name, set, what)
      ->default_str(CLI::detail::to_string(static_cast<double>(value.count()) / 1000.0))
      ->type_name("SECONDS")
      ->check(common::in_range(least, 3600.0));
}

void add_count(CLI::App& app, const std::string& name, std::size_t& value,
               const std::string& what) {
  app.add_option(name, value, what)
      ->capture_default_str()
      ->type_name("N")
      ->check(common::in_range(1, 65536));
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
  add_seconds(app, "--drain-delay", net.drain_delay,
              "from SIGTERM until clients are sent away; meanwhile not ready, so that a load "
              "balancer notices, but new clients are served",
              0.0);
  add_seconds(app, "--drain-timeout", net.drain_timeout,
              "at most, to finish frames in flight after SIGTERM");
  add_count(app, "--max-connections", net.connections.total, "clients in all");
  add_count(app, "--max-unauthenticated", net.connections.unauthenticated,
            "clients that have not said hello yet");
  add_count(app, "--max-per-address", net.connections.per_address, "clients from one address");
  add_seconds(app, "--stuck-after", net.stuck_after,
              "without progress of the renderer before /livez fails");
  add_seconds(app, "--stuck-reload-after", net.stuck_reload_after,
              "for a reload to make a new renderer before /livez fails");
  app.add_option("--environments-per-second", net.session.environments_per_second,
                 "environments that a client may send in the long run")
      ->capture_default_str()
      ->check(common::in_range(0.0, 1000.0));
  app.add_option("--max-load", net.admission.load,
                 "part of the renderer's time that sessions may need together; further ones are "
                 "told to come back later. 0: no limit")
      ->capture_default_str()
      ->check(common::in_range(0.0, 1000.0));
  app.add_option("--max-session-memory", net.admission.memory,
                 "bytes that sessions may need together, as 512MB; 0: no limit")
      ->capture_default_str()
      ->transform(CLI::AsSizeValue(false));
  add_count(app, "--max-admin", net.connections.admin, "connections to the admin port");
}

void add_security_options(CLI::App& app, net::ServerConfig& net, std::string& token_file,
                          bool& insecure) {
  app.add_option("--token-file", token_file,
                 "file with a line for each token that admits clients: the token, and behind it "
                 "its rights (view, environment; none: all). Without it they need none")
      ->type_name("FILE");
  const std::map<std::string, net::EnvironmentFrom> senders{
      {"none", net::EnvironmentFrom::None},
      {"authorised", net::EnvironmentFrom::Authorised},
      {"any", net::EnvironmentFrom::Any}};
  app.add_option("--environment-from", net.environment_from,
                 "whose environments change the light for all (everybody may change the light of "
                 "the own session): none, authorised (by a token with "
                 "that right, or everybody's where there are no tokens) or any")
      ->transform(CLI::CheckedTransformer(senders).description(""))
      ->default_str("authorised");
  app.add_option("--trusted-proxy", net.trusted_proxies,
                 "address whose connections begin with a PROXY header (version 2); repeatable")
      ->transform(CLI::Validator(
          [](std::string& text) {
            boost::system::error_code ec;
            const auto address = boost::asio::ip::make_address(text, ec);
            if (ec) return "'" + text + "' is not a numeric IP address";
            text = net::unmapped(address).to_string();
            return std::string();
          },
          ""))
      ->type_name("ADDRESS");
  app.add_option("--tls-certificate", net.tls.certificate,
                 "chain of certificates; turns TLS 1.3 on")
      ->type_name("PEM");
  app.add_option("--tls-key", net.tls.key, "its private key")->type_name("PEM");
  app.add_flag("--insecure", insecure,
               "serve other machines although neither a token nor TLS is asked for");
}

void add_web_options(CLI::App& app, std::string& address, net::WebOptions& web) {
  app.add_option("--web", address,
                 "where browsers get the page and hold sessions over WebSocket; port 0 as above. "
                 "Without it, nowhere")
      ->type_name("ADDRESS:PORT");
  app.add_option("--web-folder", web.folder,
                 "folder with the files of the page, instead of the built-in ones")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory.description(""));
  app.add_option("--web-origin", web.origins,
                 "whose pages may open sessions, as https://example.org:8443; repeatable. Without "
                 "it, the server's own page")
      ->check(CLI::Validator(
          [](const std::string& text) {
            // As browsers send it: a scheme, a host, perhaps a port, and no path.
            const std::size_t scheme = text.find("://");
            const bool is_origin = scheme != std::string::npos && scheme + 3 < text.size() &&
                                   text.find_first_of("/?# ", scheme + 3) == std::string::npos;
            return is_origin ? std::string() : "'" + text + "' is not an origin";
          },
          ""))
      ->type_name("ORIGIN");
}

// A size in MiB, as a number of bytes.
void add_mebibytes(CLI::App& app, const std::string& name, std::uint64_t& bytes,
                   const std::string& what) {
  app.add_option_function<std::uint64_t>(
         name, [&bytes](std::uint64_t size) { bytes = size * protocol::kMiB; }, what)
      ->default_str(std::to_string(bytes / protocol::kMiB))
      ->type_name("MIB")
      ->check(common::in_range(1, 1 << 20));
}

void add_record_options(CLI::App& app, record::RecordOptions& record) {
  app.add_option("--record-sessions", record.folder,
                 "folder for a record of each session, with all camera pictures and composites but "
                 "without tokens, which amalgam-load --replay plays again. Without it nothing is "
                 "recorded")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory.description(""));
  add_mebibytes(app, "--record-session-size", record.session_bytes,
                "of one record; a full one ends, and its session goes on");
  add_mebibytes(app, "--record-total-size", record.total_bytes,
                "of all records in the folder, earlier ones too");
}

bool is_loopback(const std::string& address) {
  return address.rfind("127.", 0) == 0 || address == "::1" || address.rfind("::ffff:127.", 0) == 0;
}

// Whoever opens a server to a network should have meant to.
void check_exposure(const net::ServerConfig& net, bool insecure) {
  if (insecure || !net.grants.empty() || !net.tls.certificate.empty()) return;
  for (const common::HostPort& address : {net.listen, net.web.value_or(net.listen)}) {
    if (is_loopback(address.host)) continue;
    throw std::invalid_argument("anybody could use " + to_string(address) +
                                ": give --token-file or --tls-certificate, or say --insecure");
  }
}

// The admin port asks for nothing.
void check_pictures(const net::ServerConfig& net, bool insecure) {
  if (insecure || !net.admin_pictures || is_loopback(net.admin.host)) return;
  throw std::invalid_argument("anybody could see the clients' pictures at " + to_string(net.admin) +
                              ": take --admin-pictures away, or say --insecure");
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
  // A mistyped key would leave a limit, or a token, unset without a word.
  app.allow_config_extras(CLI::config_extras_mode::error);
  app.add_option("--scene", options.scene, "glTF scene to serve")
      ->capture_default_str()
      ->type_name("FILE");
  app.add_option("--listen", listen, "where clients connect; port 0 takes a free one")
      ->capture_default_str()
      ->type_name("ADDRESS:PORT");
  app.add_option(
         "--admin", admin,
         "where the status page (/) and /livez /readyz /metrics /state are; port 0 as above")
      ->capture_default_str()
      ->type_name("ADDRESS:PORT");
  app.add_flag("--admin-pictures", options.net.admin_pictures,
               "show the last composite of each session on the status page, to whoever reaches it "
               "(/pictures/SESSION.jpg). Off, none is kept");
  std::string agent;
  app.add_option("--agent-check", agent,
                 "where a load balancer reads the free capacity (HAProxy's agent-check); port 0 as "
                 "above. Without it, nowhere")
      ->type_name("ADDRESS:PORT");
  std::string web;
  add_web_options(app, web, options.net.web_options);
  bool insecure = false;
  add_security_options(app, options.net, token_file, insecure);
  tools::add_renderer_options(app, options.render.renderer);
  app.add_option("--quality", options.render.renderer.jpeg_quality,
                 "JPEG quality, 1 to 100, of composites for clients that leave it to the server, "
                 "where they "
                 "cannot take over the quality and the unchanged blocks of the camera's JPEG")
      ->capture_default_str()
      ->type_name("Q")
      ->check(common::in_range(1, 100));
  app.add_option("--log-level", options.log_level, "how much is logged to standard error")
      ->capture_default_str()
      ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}));
  app.add_option("--log-format", options.log_format, "of each line: text, or json for an object")
      ->capture_default_str()
      ->check(CLI::IsMember({"text", "json"}));
  add_net_options(app, options.net);
  add_record_options(app, options.net.record);

  if (!common::parse_command_line(app, argc, argv)) return std::nullopt;
  options.net.listen = common::parse_host_port(listen);
  options.net.admin = common::parse_host_port(admin);
  if (!agent.empty()) options.net.agent = common::parse_host_port(agent);
  if (!web.empty()) options.net.web = common::parse_host_port(web);
  options.net.web_options.files = web::web_files();
  options.net.web_options.made =
      printed_sheets(std::filesystem::path(options.scene).filename().string());
  options.net.status_files = web::status_files();
  options.net.ray_tracer = frame::ray_tracer_version();
  if (!token_file.empty()) options.net.grants = net::read_grants(token_file);
  check_exposure(options.net, insecure);
  check_pictures(options.net, insecure);
  return options;
}

}  // namespace amalgam
