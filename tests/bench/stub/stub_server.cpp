// A server whose renderer takes a known time for each frame and gives the camera's picture back:
// what is left of a latency is the client's and the network's (tests/web/tools/latency.js).
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>

#include "common/log.h"
#include "common/parse_command_line.h"
#include "common/run_program.h"
#include "net/server.h"
#include "support/net/stub_frame_service.h"
#include "web/web_files.h"

namespace {

using namespace amalgam;

// Ended by SIGTERM.
void serve(std::chrono::milliseconds cost) {
  net::ServerConfig config;
  config.listen.port = config.admin.port = 0;
  config.web = common::HostPort{"127.0.0.1", 0};
  config.web_options.files = web::web_files();
  test::StubFrameService service;
  service.set_cost(cost);
  net::Server server(config);
  server.handle_signals([] {});
  server.serve(service);
  std::cout << "listening on " << to_string(server.address()) << " web "
            << to_string(server.web_address().value()) << std::endl;
  server.run();
}

}  // namespace

int main(int argc, char** argv) {
  return common::run_program("amalgam-stub-server", [&] {
    int cost = 20;
    CLI::App app("Serves camera pictures as they are, after a known time.", "amalgam-stub-server");
    app.add_option("--cost", cost, "milliseconds for each frame")->capture_default_str();
    if (!common::parse_command_line(app, argc, argv)) return 0;
    common::set_log_level("warn");
    serve(std::chrono::milliseconds(cost));
    return 0;
  });
}
