// The network's bytes: a stream says the same however it is cut, within its limits.
#include "protocol/framing.h"

#include <algorithm>
#include <vector>

#include "common/log.h"
#include "fuzz/target.h"
#include "protocol/limits.h"
#include "protocol/protobuf_log.h"

namespace amalgam::fuzz {
namespace {

using protocol::Decoder;

std::string text_of(const Decoder::Result& result) {
  if (const auto* envelope = std::get_if<protocol::Envelope>(&result)) {
    return "message " + envelope->SerializeAsString();
  }
  if (const auto* refused = std::get_if<Decoder::TooManyPoses>(&result)) {
    return "poses of frame " + std::to_string(refused->frame_id) + ", " +
           std::to_string(refused->message_bytes) + " bytes";
  }
  return "failure " + std::get<Decoder::Failure>(result).what;
}

// What a stream says that arrives in pieces.
std::vector<std::string> told(const protocol::SizeLimits& limits, std::span<const std::byte> stream,
                              std::size_t piece) {
  const std::size_t largest =
      std::max({limits.control, limits.camera_frame, limits.environment, limits.composite});
  Decoder decoder(limits);
  std::vector<std::string> said;
  while (!stream.empty()) {
    std::span<const std::byte> input = stream.first(std::min(piece, stream.size()));
    stream = stream.subspan(input.size());
    for (;;) {
      const std::size_t left = input.size();
      const Decoder::Result result = decoder.next(input);
      if (std::holds_alternative<Decoder::NeedMore>(result)) break;
      said.push_back(text_of(result));
      if (std::holds_alternative<Decoder::Failure>(result)) return said;
      AMALGAM_CHECK(input.size() < left, "a message of no bytes");
      AMALGAM_CHECK(decoder.bytes_of_unfinished() == 0, "a message that goes on");
    }
    AMALGAM_CHECK(input.empty(), std::to_string(input.size()) + " bytes were left");
    AMALGAM_CHECK(decoder.bytes_of_unfinished() <= protocol::kLengthBytes + largest,
                  std::to_string(decoder.bytes_of_unfinished()) + " bytes are kept");
  }
  return said;
}

bool keep_quiet() {
  common::set_log_level("error");
  protocol::take_over_protobuf_log();
  return true;
}

}  // namespace
}  // namespace amalgam::fuzz

// One byte for the limits, one for the size of the pieces, then the stream.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amalgam;
  static const bool quiet = fuzz::keep_quiet();
  if (size < 3 || !quiet) return -1;
  const protocol::SizeLimits all[] = {protocol::limits_of_server(), protocol::limits_before_hello(),
                                      protocol::limits_of_client()};
  const protocol::SizeLimits& limits = all[data[0] % 3];
  const auto stream = fuzz::as_bytes(data, size).subspan(2);
  const auto whole = fuzz::told(limits, stream, stream.size());
  const auto cut = fuzz::told(limits, stream, 1 + data[1] % 32);
  AMALGAM_CHECK(whole == cut, std::to_string(whole.size()) + " things said, in pieces " +
                                  std::to_string(cut.size()));
  return 0;
}
