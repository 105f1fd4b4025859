// amalgam-server: loads a scene, serves clients until it is told to end, ends cleanly.
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>

#include "common/log.h"
#include "common/run_program.h"
#include "frame/render_thread.h"
#include "frame/rendering_threads.h"
#include "net/server.h"
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

void serve(const ServerOptions& options) {
  frame::limit_llvmpipe_threads(options.render.renderer);
  std::unique_ptr<frame::FrameService> service;  // outlives the server, which uses it
  net::Server server(options.net);
  server.drain_on_signals();
  NetworkThread network(server);  // answers on the admin port while the scene is loaded
  common::log_info("loading " + options.scene);
  service = frame::make_render_service(options.scene, options.render);
  server.serve(*service);
  // For people and for scripts that asked for port 0.
  std::cout << "listening on " << to_string(server.address()) << " admin "
            << to_string(server.admin_address()) << std::endl;
  network.join();
  common::log_info("ended");
}

}  // namespace
}  // namespace amalgam

int main(int argc, char** argv) {
  // Whoever reads our output may go away; that is no reason to end before the time.
  return amalgam::common::run_program("amalgam-server", [&] {
    const std::optional<amalgam::ServerOptions> options = amalgam::parse_server_options(argc, argv);
    if (!options) return EXIT_SUCCESS;
    amalgam::common::set_log_level(options->log_level);
    amalgam::serve(*options);
    return EXIT_SUCCESS;
  });
}
