// amalgam-server: loads a scene, serves clients until it is told to end, ends cleanly.
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>

#include "common/log.h"
#include "common/run_program.h"
#include "common/standard_streams.h"
#include "frame/render_thread.h"
#include "frame/rendering_threads.h"
#include "net/memory_trim.h"
#include "net/server.h"
#include "protocol/protobuf_log.h"
#include "server/reloader.h"
#include "server/server_options.h"

namespace amalgam {
namespace {

class NetworkThread {
 public:
  explicit NetworkThread(net::Server& server)
      : server_(server), thread_([this] {
          try {
            server_.run();
          } catch (...) {
            failure_ = std::current_exception();
          }
        }) {}
  ~NetworkThread() {
    server_.stop();
    if (thread_.joinable()) thread_.join();
  }
  void join() {
    thread_.join();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  net::Server& server_;
  std::exception_ptr failure_;
  std::thread thread_;  // last: begins when everything else is there
};

// The renderer's thread calls back into the server and the reloader, so it ends before they do.
struct StopsRendering {
  std::unique_ptr<frame::RenderThread>& service;
  ~StopsRendering() {
    if (service) service->stop();
  }
};

void serve(const ServerOptions& options, const ReloadOptions& reload_options) {
  frame::limit_llvmpipe_threads(options.render.renderer);
  std::unique_ptr<frame::RenderThread> service;  // outlives the server, which uses it
  net::Server server(options.net);
  std::optional<Reloader> reloader;
  const StopsRendering stops_rendering{service};
  server.handle_signals([&] { reloader->reload(); });  // none before the server serves
  NetworkThread network(server);  // answers on the admin port while the scene is loaded
  common::log_info("loading " + options.scene);
  service = std::make_unique<frame::RenderThread>(options.scene, options.render);
  reloader.emplace(server, *service, reload_options);
  server.serve(*service);
  // For people and for scripts that asked for port 0.
  std::cout << "listening on " << to_string(server.address()) << " admin "
            << to_string(server.admin_address());
  if (const auto agent = server.agent_address()) std::cout << " agent " << to_string(*agent);
  if (const auto web = server.web_address()) std::cout << " web " << to_string(*web);
  std::cout << std::endl;
  network.join();
  common::log_info("ended");
}

}  // namespace
}  // namespace amalgam

int main(int argc, char** argv) {
  amalgam::common::open_closed_standard_streams();
  amalgam::net::share_one_heap();
  // Whoever reads our output may go away; that is no reason to end before the time.
  return amalgam::common::run_program("amalgam-server", [&] {
    const std::optional<amalgam::ServerOptions> options = amalgam::parse_server_options(argc, argv);
    if (!options) return EXIT_SUCCESS;
    amalgam::common::set_log_level(options->log_level);
    amalgam::common::set_log_format(options->log_format);
    amalgam::protocol::take_over_protobuf_log();
    const amalgam::common::BackgroundLog log;
    amalgam::serve(*options, [=] { return *amalgam::parse_server_options(argc, argv); });
    return EXIT_SUCCESS;
  });
}
