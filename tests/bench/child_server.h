// An amalgam-server in a process of its own.
#pragma once

#include <filesystem>
#include <memory>

#include "net/server_config.h"

namespace amalgam::tests {
class ChildProcess;
}

namespace amalgam::bench {

class ChildServer {
 public:
  static bool is_built();

  // Returns when clients may connect. Throws std::runtime_error.
  explicit ChildServer(const std::filesystem::path& scene);
  ~ChildServer();

  const common::HostPort& address() const { return address_; }
  double resident_megabytes() const;  // 10^6 bytes

 private:
  std::unique_ptr<tests::ChildProcess> process_;
  common::HostPort address_;
};

}  // namespace amalgam::bench
