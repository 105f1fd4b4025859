// amalgam-load: N clients and one JSON summary, or one recorded session played again.
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "client/tools/load/arrivals.h"
#include "client/tools/load/load_client.h"
#include "client/tools/load/load_image.h"
#include "client/tools/load/load_options.h"
#include "client/tools/load/load_summary.h"
#include "client/tools/load/run_replay.h"
#include "common/run_program.h"

namespace amalgam::load {
namespace {

void write_latencies(const LoadSummary& summary, const std::string& path) {
  std::ofstream file(path);
  file << "due_s,latency_ms\n";
  for (const LoadSummary::Due& frame : summary.due) {
    file << frame.second << ',' << frame.latency << '\n';
  }
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

LoadSummary run(const LoadOptions& options) {
  const LoadImage image =
      options.image.empty() ? grey_image(options.width, options.height) : read_image(options.image);
  LoadSummary summary;
  summary.clients = options.clients;
  boost::asio::io_context io(1);
  const auto begin = std::chrono::steady_clock::now();
  const auto start_one = [&](int number) {
    std::make_shared<LoadClient>(io, options, image, summary, number)->start(begin);
  };
  Arrivals arrivals(io, options, begin, start_one);
  if (options.arrivals > 0.0) {
    arrivals.wait();
  } else {
    for (int i = 0; i < options.clients; ++i) start_one(i);
  }
  io.run();
  if (options.arrivals > 0.0) summary.clients = arrivals.count();
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return summary;
}

}  // namespace
}  // namespace amalgam::load

int main(int argc, char** argv) {
  return amalgam::common::run_program("amalgam-load", [&] {
    const auto options = amalgam::load::parse_load_options(argc, argv);
    if (!options) return EXIT_SUCCESS;
    if (!options->replay.empty()) {
      const amalgam::load::ReplayOutcome outcome = amalgam::load::run_replay(*options);
      std::cout << outcome.json << std::endl;
      return outcome.good ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    const amalgam::load::LoadSummary summary = amalgam::load::run(*options);
    if (!options->latencies.empty()) {
      amalgam::load::write_latencies(summary, options->latencies);
    }
    std::cout << to_json(summary) << std::endl;
    const bool none_expected = options->fault == amalgam::load::Fault::HalfOpen ||
                               options->fault == amalgam::load::Fault::WrongToken;
    if (summary.welcomed > 0 || none_expected) return EXIT_SUCCESS;
    throw std::runtime_error("no client was let in by " + to_string(options->server));
  });
}
