#include "client/tools/load/load_options.h"

#include <CLI/CLI.hpp>
#include <map>
#include <stdexcept>

#include "common/build_info.h"
#include "common/image_size.h"
#include "common/parse_command_line.h"
#include "common/token_file.h"
#include "protocol/client_tls.h"
#include "protocol/limits.h"

namespace amalgam::load {

std::optional<LoadOptions> parse_load_options(int argc, const char* const* argv) {
  const std::map<std::string, Fault> faults{{"none", Fault::None},
                                            {"bad-pose", Fault::BadPose},
                                            {"bad-image", Fault::BadImage},
                                            {"cut", Fault::Cut},
                                            {"garbage", Fault::Garbage},
                                            {"half-open", Fault::HalfOpen},
                                            {"hello-only", Fault::HelloOnly},
                                            {"wrong-token", Fault::WrongToken},
                                            {"slow-reader", Fault::SlowReader},
                                            {"environments", Fault::Environments}};
  LoadOptions options;
  std::string server = "127.0.0.1:7447";
  std::string fault = "none";
  std::string token_file, certificate_authority, size;
  bool tls = false;
  double duration = 10.0, stay = 0.0;
  CLI::App app(
      "Puts scripted load on an amalgam-server and prints what came back as JSON.\n\n"
      "Latencies begin when a frame was due, not when it could be sent, so that a server that "
      "holds "
      "its clients up does not look quick (coordinated omission). latency_ms is of composites; "
      "due_latency_ms is of all frames that were due: one that was not sent, or that the server "
      "skipped, waits for the next composite.\n\n"
      "--replay plays a session that amalgam-server --record-sessions has recorded, and compares "
      "its composites byte for byte: they are equal on the same build, scene, renderer's options "
      "and kind of hardware. Other options than --server, --token-file, --tls and --ca do not "
      "count "
      "then. Ends with 1 if a composite differs.",
      "amalgam-load");
  app.set_version_flag("--version", common::version_line("amalgam-load"));
  app.add_option("--server", server, "the server")
      ->capture_default_str()
      ->type_name("ADDRESS:PORT");
  app.add_option("--clients", options.clients, "clients at once")
      ->capture_default_str()
      ->type_name("N")
      ->check(common::in_range(1, 10000));
  app.add_option("--rate", options.rate, "frames a second of each client")
      ->capture_default_str()
      ->type_name("HZ")
      ->check(common::in_range(0.01, 10000.0));
  auto* const frames = app.add_option("--frames", options.frames, "frames of each client")
                           ->type_name("N")
                           ->check(common::in_range(1, 1000000000));
  app.add_option("--duration", duration, "how long frames are sent")
      ->capture_default_str()
      ->type_name("SECONDS")
      ->check(common::in_range(0.01, 1e6))
      ->excludes(frames);
  auto* const arrivals =
      app.add_option(
             "--arrivals", options.arrivals,
             "clients a second that arrive at random times (Poisson) until the duration is "
             "over, however many are there (an open loop); --clients counts no more. 0: all "
             "clients are there from the start")
          ->capture_default_str()
          ->type_name("HZ")
          ->check(common::in_range(0.0, 10000.0))
          ->excludes(frames);
  app.add_option("--stay", stay, "how long a client that arrives sends frames; 0: to the end")
      ->capture_default_str()
      ->type_name("SECONDS")
      ->check(common::in_range(0.0, 1e6))
      ->needs(arrivals);
  auto* const image =
      app.add_option("--image", options.image, "what every frame shows; default mid grey")
          ->type_name("JPEG");
  app.add_option("--size", size, "of mid grey, pixels; default 640x480")
      ->type_name("WxH")
      ->excludes(image);
  app.add_option("--latencies", options.latencies,
                 "file for the latency of every frame that was due: when, s, and latency, ms")
      ->type_name("CSV");
  app.add_option("--first-source", options.first_source, "last number of the first of --sources")
      ->capture_default_str()
      ->type_name("N")
      ->check(common::in_range(1, 500));
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
      ->check(common::in_range(0, 65000));
  app.add_flag("--moving", options.moving,
               "the marker moves; otherwise frames are like the last one, as on a tripod, and cost "
               "a tenth");
  app.add_option(
         "--faults", fault,
         "what the clients do wrong: poses of NaN, images of garbage, a connection that ends "
         "in the middle of its last frame, random bytes after the hello, no hello, nothing "
         "but a hello, a wrong token, no reading, an environment with each frame. With "
         "--arrivals they come as a flood")
      ->capture_default_str()
      ->check(CLI::IsMember(faults));
  auto* const replay =
      app.add_option("--replay", options.replay,
                     "a recorded session, with the pictures of its client, to be played again in "
                     "its own time. Frames that the server skips now or skipped then are not "
                     "compared; a metered exposure follows the frames that were not")
          ->type_name("FILE")
          ->check(CLI::ExistingFile.description(""));
  app.add_flag("--as-fast-as-possible", options.as_fast_as_possible,
               "each frame that was rendered is sent when the last one is answered, with the poses "
               "that it was rendered with, so that all are rendered again in the same order")
      ->needs(replay);
  app.add_option("--output", options.output,
                 "folder for frames that differ, as frame-000001-recorded.jpg and "
                 "frame-000001-replayed.jpg by their number in the session")
      ->type_name("FOLDER")
      ->needs(replay);
  if (!common::parse_command_line(app, argc, argv)) return std::nullopt;
  options.server = common::parse_host_port(server);
  options.fault = faults.at(fault);
  if (!size.empty()) {
    const glm::ivec2 sides = common::parse_image_size(size, static_cast<int>(protocol::kMaxSide));
    options.width = sides.x;
    options.height = sides.y;
  }
  options.stay = std::chrono::milliseconds(static_cast<std::int64_t>(stay * 1000.0));
  if (tls) options.tls = protocol::client_tls(certificate_authority);
  options.duration = std::chrono::milliseconds(static_cast<std::int64_t>(duration * 1000.0));
  if (!token_file.empty())
    options.token = common::read_token_file(token_file, protocol::kMaxTokenBytes);
  return options;
}

}  // namespace amalgam::load
