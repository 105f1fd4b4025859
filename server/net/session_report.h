// What the /state page says of one session.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace amalgam::net {

struct SessionReport {
  std::uint64_t id = 0;
  std::string peer;
  std::string transport;
  std::string state;
  int width = 0, height = 0;  // pixels
  std::uint64_t received = 0, sent = 0, skipped = 0;
  std::size_t in_flight = 0;
  bool own_environment = false;
  std::string record;              // what became of its record (record/track.h)
  std::uint64_t record_bytes = 0;  // written
};

}  // namespace amalgam::net
