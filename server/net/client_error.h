// A client's mistake: thrown where it is found, caught by the session, answered by an Error.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "protocol/amalgam.pb.h"

namespace amalgam::net {

struct ClientError : std::runtime_error {
  ClientError(protocol::Error::Code code_, const std::string& text, std::uint64_t frame_id_ = 0)
      : std::runtime_error(text), code(code_), frame_id(frame_id_) {}
  protocol::Error::Code code;
  std::uint64_t frame_id;  // the client's number; 0: not about a frame
};

// Whether the session goes on after this Error (PROTOCOL.md, table of error codes).
inline bool is_survivable(protocol::Error::Code code) {
  using protocol::Error;
  return code == Error::POSE_REJECTED || code == Error::BAD_IMAGE ||
         code == Error::TOO_MANY_POSES || code == Error::UNSUPPORTED ||
         code == Error::BAD_ENVIRONMENT;
}

}  // namespace amalgam::net
