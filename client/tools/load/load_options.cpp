#include "client/tools/load/load_options.h"

#include <CLI/CLI.hpp>
#include <map>
#include <stdexcept>

#include "common/build_info.h"
#include "common/parse_command_line.h"
#include "common/token_file.h"
#include "protocol/client_tls.h"
#include "protocol/limits.h"

namespace amalgam::load {

std::optional<LoadOptions> parse_load_options(int argc, const char* const* argv) {
  const std::map<std::string, Fault> faults{{"none", Fault::None},
                                            {"bad-pose", Fault::BadPose},
                                            {"bad-image", Fault::BadImage},
                                            {"cut", Fault::Cut}};
  LoadOptions options;
  std::string server = "127.0.0.1:7447";
  std::string fault = "none";
  std::string token_file, certificate_authority;
  bool tls = false;
  double duration = 10.0;
  CLI::App app("Puts scripted load on an amalgam-server and prints what came back as JSON.",
               "amalgam-load");
  app.set_version_flag("--version", common::version_line("amalgam-load"));
  app.add_option("--server", server, "the server")
      ->capture_default_str()
      ->type_name("ADDRESS:PORT");
  app.add_option("--clients", options.clients, "clients at once")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  app.add_option("--rate", options.rate, "frames a second of each client")
      ->capture_default_str()
      ->type_name("HZ")
      ->check(CLI::Range(0.01, 10000.0));
  auto* const frames = app.add_option("--frames", options.frames, "frames of each client")
                           ->type_name("N")
                           ->check(CLI::Range(1, 1000000000));
  app.add_option("--duration", duration, "how long frames are sent")
      ->capture_default_str()
      ->type_name("SECONDS")
      ->check(CLI::Range(0.01, 1e6))
      ->excludes(frames);
  app.add_option("--image", options.image, "what every frame shows; default mid grey, 640 x 480")
      ->type_name("JPEG");
  app.add_option("--token-file", token_file, "file with the server's secret")->type_name("FILE");
  auto* const tls_flag =
      app.add_flag("--tls", tls, "encrypt, and ask the server for a certificate of its name");
  app.add_option("--ca", certificate_authority,
                 "certificates that are trusted with --tls; without it the system's")
      ->type_name("PEM")
      ->needs(tls_flag);
  app.add_option("--sources", options.sources,
                 "loopback addresses (127.0.0.1, 127.0.0.2, ...) that clients come from in turn, "
                 "because servers limit the clients of one address; 0: one, the system's choice")
      ->capture_default_str()
      ->type_name("N")
      ->check(CLI::Range(0, 65000));
  app.add_flag("--moving", options.moving,
               "the marker moves; otherwise frames are like the last one, as on a tripod, and cost "
               "a tenth");
  app.add_option("--faults", fault, "what the clients do wrong")
      ->capture_default_str()
      ->check(CLI::IsMember(faults));
  if (!common::parse_command_line(app, argc, argv)) return std::nullopt;
  options.server = common::parse_host_port(server);
  options.fault = faults.at(fault);
  if (tls) options.tls = protocol::client_tls(certificate_authority);
  options.duration = std::chrono::milliseconds(static_cast<std::int64_t>(duration * 1000.0));
  if (!token_file.empty())
    options.token = common::read_token_file(token_file, protocol::kMaxTokenBytes);
  return options;
}

}  // namespace amalgam::load
