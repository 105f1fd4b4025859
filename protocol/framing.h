// Frames Envelopes in a byte stream: a 4-byte little-endian length, then one Envelope. Used by both
// ends. Where the transport has messages itself, each is one Envelope without the length. A length
// is checked before anything is allocated for it, and the bytes are looked at before any is parsed
// (envelope_scan.h).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include "protocol/amalgam.pb.h"
#include "protocol/envelope_scan.h"

namespace amalgam::protocol {

// The largest accepted Envelope, in bytes, by its first byte. Whoever never receives a kind with an
// image takes no more of it than of a control message.
struct SizeLimits {
  std::size_t control = 0;
  std::size_t camera_frame = 0;
  std::size_t environment = 0;
  std::size_t composite = 0;
};
SizeLimits limits_before_hello();
SizeLimits limits_of_server();  // what a server accepts after the hello
SizeLimits limits_of_client();

// The length and the message as bytes: an Envelope, or what is framed in the same way.
std::string encode(const google::protobuf::MessageLite& message);

class Decoder {
 public:
  struct NeedMore {};
  struct Failure {  // PROTOCOL_ERROR: the stream cannot be read any further
    std::string what;
  };
  struct TooManyPoses {  // a CameraFrame that was neither kept nor parsed; the next message follows
    std::uint64_t frame_id = 0;
    std::size_t message_bytes = 0;
  };
  using Result = std::variant<NeedMore, Envelope, Failure, TooManyPoses>;

  explicit Decoder(const SizeLimits& limits) : limits_(limits) {}

  // Consumes bytes of `input` up to the end of one message and returns it; NeedMore if the input
  // ends before. After a Failure every call returns the same one.
  Result next(std::span<const std::byte>& input);

  // What is known of a piece of a message when the transport marks where messages end.
  struct Part {
    std::size_t at_least_left = 0;  // bytes of the message that certainly follow
    bool last = false;
  };
  // The same for such a transport: consumes all of `input`, which is one piece of one message.
  Result next_part(std::span<const std::byte>& input, const Part& part);

  // For the messages that begin after this call.
  void set_limits(const SizeLimits& limits) { limits_ = limits; }

  // Received bytes of an incomplete message, with kLengthBytes; 0 between messages.
  std::size_t bytes_of_unfinished() const { return received_; }

 private:
  std::optional<std::string> judge_length() const;
  std::optional<std::string> judge_kind(std::byte first) const;
  std::optional<std::string> keep(std::span<const std::byte> bytes);
  Result fail(std::string what);
  Result finish();

  SizeLimits limits_;
  std::size_t received_ = 0;  // of the current message, with kLengthBytes
  std::size_t length_ = 0;    // of the Envelope, or what is known of it
  std::byte first_{};         // of the Envelope
  std::string body_;
  EnvelopeScan scan_;
  std::optional<Failure> failure_;
};

}  // namespace amalgam::protocol
