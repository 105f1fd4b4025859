// amalgam-load: N clients, one JSON summary.
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "client/tools/load/load_client.h"
#include "client/tools/load/load_image.h"
#include "client/tools/load/load_options.h"
#include "client/tools/load/load_summary.h"
#include "common/run_program.h"

namespace amalgam::load {
namespace {

LoadSummary run(const LoadOptions& options) {
  const LoadImage image = options.image.empty() ? grey_image(640, 480) : read_image(options.image);
  LoadSummary summary;
  summary.clients = options.clients;
  boost::asio::io_context io(1);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < options.clients; ++i) {
    std::make_shared<LoadClient>(io, options, image, summary, i)->start();
  }
  io.run();
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return summary;
}

}  // namespace
}  // namespace amalgam::load

int main(int argc, char** argv) {
  return amalgam::common::run_program("amalgam-load", [&] {
    const auto options = amalgam::load::parse_load_options(argc, argv);
    if (!options) return EXIT_SUCCESS;
    const amalgam::load::LoadSummary summary = amalgam::load::run(*options);
    std::cout << to_json(summary) << std::endl;
    if (summary.welcomed > 0) return EXIT_SUCCESS;
    throw std::runtime_error("no client was let in by " + to_string(options->server));
  });
}
