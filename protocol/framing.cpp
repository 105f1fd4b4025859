#include "protocol/framing.h"

#include <algorithm>
#include <utility>

#include "protocol/limits.h"

namespace amalgam::protocol {
namespace {

// The first byte of an Envelope whose body is this field: field number, then wire type 2.
constexpr std::byte tag_of(int field) {
  return static_cast<std::byte>((field << 3) | 2);
}

bool may_hold_image(Envelope::BodyCase body) {
  return body == Envelope::kCameraFrame || body == Envelope::kEnvironment ||
         body == Envelope::kComposite;
}

bool begins_image(std::byte first) {
  return first == tag_of(Envelope::kCameraFrameFieldNumber) ||
         first == tag_of(Envelope::kEnvironmentFieldNumber) ||
         first == tag_of(Envelope::kCompositeFieldNumber);
}

}  // namespace

SizeLimits limits_before_hello() {
  return {kMaxBeforeHelloBytes, kMaxBeforeHelloBytes};
}
SizeLimits limits_of_server() {
  return {kMaxControlBytes, kMaxCameraFrameBytes};
}
SizeLimits limits_of_client() {
  return {kMaxControlBytes, kMaxCompositeBytes};
}

std::string encode(const Envelope& envelope) {
  const std::size_t length = envelope.ByteSizeLong();
  std::string bytes;
  bytes.reserve(kLengthBytes + length);
  for (std::size_t i = 0; i < kLengthBytes; ++i) {
    bytes.push_back(static_cast<char>((length >> (8 * i)) & 0xff));
  }
  envelope.AppendToString(&bytes);
  return bytes;
}

Decoder::Result Decoder::next(std::span<const std::byte>& input) {
  if (failure_) return *failure_;
  while (!input.empty()) {
    if (received_ < kLengthBytes) {
      length_ |= std::to_integer<std::size_t>(input.front()) << (8 * received_);
      input = input.subspan(1);
      ++received_;
      if (received_ == kLengthBytes) {
        if (const auto defect = judge_length()) return fail(*defect);
      }
      continue;
    }
    if (received_ == kLengthBytes) {
      if (const auto defect = judge_kind(input.front())) return fail(*defect);
      body_.reserve(length_);
    }
    const std::size_t missing = kLengthBytes + length_ - received_;
    const std::size_t taken = std::min(missing, input.size());
    body_.append(reinterpret_cast<const char*>(input.data()), taken);
    input = input.subspan(taken);
    received_ += taken;
    if (taken == missing) return finish();
  }
  return NeedMore{};
}

std::optional<std::string> Decoder::judge_length() const {
  if (length_ == 0) return "a message of length 0";
  if (length_ > limits_.image) {
    return "a message of " + std::to_string(length_) + " bytes where at most " +
           std::to_string(limits_.image) + " are accepted";
  }
  return std::nullopt;
}

std::optional<std::string> Decoder::judge_kind(std::byte first) const {
  if (length_ <= limits_.control || begins_image(first)) return std::nullopt;
  return "a message without an image of " + std::to_string(length_) + " bytes where at most " +
         std::to_string(limits_.control) + " are accepted";
}

Decoder::Result Decoder::fail(std::string what) {
  failure_ = Failure{std::move(what)};
  body_ = std::string();
  return *failure_;
}

Decoder::Result Decoder::finish() {
  Envelope envelope;
  if (!envelope.ParseFromString(body_)) return fail("bytes that are no Envelope");
  // Protobuf lets a later field of a oneof replace an earlier one, which judge_kind() cannot see.
  if (length_ > limits_.control && !may_hold_image(envelope.body_case())) {
    return fail("a message without an image that begins as one with an image");
  }
  received_ = 0;
  length_ = 0;
  body_.clear();
  return envelope;
}

}  // namespace amalgam::protocol
