// Frames Envelopes in a byte stream: a 4-byte little-endian length, then one Envelope. Used by both
// ends. A length is checked before anything is allocated for it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "protocol/amalgam.pb.h"

namespace amalgam::protocol {

// The largest accepted Envelope, in bytes, by its first byte.
struct SizeLimits {
  std::size_t control = 0;
  std::size_t image = 0;  // CameraFrame, Environment, Composite
};
SizeLimits limits_before_hello();
SizeLimits limits_of_server();  // what a server accepts after the hello
SizeLimits limits_of_client();

// The length and the Envelope as bytes.
std::string encode(const Envelope& envelope);

class Decoder {
 public:
  struct NeedMore {};
  struct Failure {  // PROTOCOL_ERROR: the stream cannot be read any further
    std::string what;
  };
  using Result = std::variant<NeedMore, Envelope, Failure>;

  explicit Decoder(const SizeLimits& limits) : limits_(limits) {}

  // Consumes bytes of `input` up to the end of one message and returns it; NeedMore if the input
  // ends before. After a Failure every call returns the same one.
  Result next(std::span<const std::byte>& input);

  // For the messages that begin after this call.
  void set_limits(const SizeLimits& limits) { limits_ = limits; }

  // Received bytes of an incomplete message; 0 between messages.
  std::size_t bytes_of_unfinished() const { return received_; }

 private:
  std::optional<std::string> judge_length() const;
  std::optional<std::string> judge_kind(std::byte first) const;
  Result fail(std::string what);
  Result finish();

  SizeLimits limits_;
  std::size_t received_ = 0;  // of the current message, its length included
  std::size_t length_ = 0;
  std::string body_;
  std::optional<Failure> failure_;
};

}  // namespace amalgam::protocol
