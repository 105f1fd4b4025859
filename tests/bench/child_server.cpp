#include "bench/child_server.h"

#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "bench/two_cores.h"
#include "support/child_process.h"

namespace amalgam::bench {
namespace {

constexpr std::chrono::seconds kStart{60}, kEnd{15};

// "listening on 127.0.0.1:40123 admin 127.0.0.1:40124"
common::HostPort read_address(tests::ChildProcess& process) {
  std::istringstream line(process.read_line(kStart));
  std::string listening, on, address;
  if (!(line >> listening >> on >> address))
    throw std::runtime_error("amalgam-server did not start");
  return common::parse_host_port(address);
}

}  // namespace

bool ChildServer::is_built() {
  return std::filesystem::exists(AMALGAM_BINARY_DIR "/bin/amalgam-server");
}

ChildServer::ChildServer(const std::filesystem::path& scene)
    : process_(std::make_unique<tests::ChildProcess>(
          "amalgam-server",
          std::vector<std::string>{"--scene", scene.string(), "--listen", "127.0.0.1:0", "--admin",
                                   "127.0.0.1:0", "--threads", std::to_string(bench_cores()),
                                   "--log-level", "warn"})),
      address_(read_address(*process_)) {}

ChildServer::~ChildServer() {
  process_->signal(SIGTERM);
  process_->wait(kEnd);
}

double ChildServer::resident_megabytes() const {
  std::ifstream status("/proc/" + std::to_string(process_->id()) + "/status");
  for (std::string word; status >> word;) {
    double kibibytes = 0.0;
    if (word == "VmRSS:" && status >> kibibytes) return kibibytes * 1024.0 / 1e6;
  }
  throw std::runtime_error("the server's memory cannot be read");
}

}  // namespace amalgam::bench
