#include "protocol/framing.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "protocol/limits.h"

namespace amalgam::protocol {
namespace {

// The first byte of an Envelope whose body is this field: field number, then wire type 2.
constexpr std::byte tag_of(int field) {
  return static_cast<std::byte>((field << 3) | 2);
}

std::size_t limit_of(std::byte first, const SizeLimits& limits) {
  if (first == tag_of(Envelope::kCameraFrameFieldNumber)) return limits.camera_frame;
  if (first == tag_of(Envelope::kEnvironmentFieldNumber)) return limits.environment;
  if (first == tag_of(Envelope::kCompositeFieldNumber)) return limits.composite;
  return limits.control;
}

std::size_t largest(const SizeLimits& limits) {
  return std::max({limits.control, limits.camera_frame, limits.environment, limits.composite});
}

}  // namespace

SizeLimits limits_before_hello() {
  return {kMaxBeforeHelloBytes, kMaxBeforeHelloBytes, kMaxBeforeHelloBytes, kMaxBeforeHelloBytes};
}
SizeLimits limits_of_server() {
  return {.control = kMaxControlBytes,
          .camera_frame = kMaxCameraFrameBytes,
          .environment = kMaxCameraFrameBytes,
          .composite = kMaxControlBytes};
}
SizeLimits limits_of_client() {
  return {.control = kMaxControlBytes,
          .camera_frame = kMaxControlBytes,
          .environment = kMaxControlBytes,
          .composite = kMaxCompositeBytes};
}

std::string encode(const google::protobuf::MessageLite& message) {
  const std::size_t length = message.ByteSizeLong();
  std::string bytes;
  bytes.reserve(kLengthBytes + length);
  for (std::size_t i = 0; i < kLengthBytes; ++i) {
    bytes.push_back(static_cast<char>((length >> (8 * i)) & 0xff));
  }
  message.AppendToString(&bytes);
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
    }
    const std::size_t missing = kLengthBytes + length_ - received_;
    const std::size_t taken = std::min(missing, input.size());
    if (const auto defect = keep(input.first(taken))) return fail(*defect);
    input = input.subspan(taken);
    received_ += taken;
    if (taken == missing) return finish();
  }
  return NeedMore{};
}

Decoder::Result Decoder::next_part(std::span<const std::byte>& input, const Part& part) {
  if (failure_) return *failure_;
  if (input.empty() && !part.last) return NeedMore{};
  // Counts as if its length had been there, so that sizes mean the same on every transport.
  if (received_ == 0) received_ = kLengthBytes;
  const bool first = received_ == kLengthBytes;
  const std::size_t seen = received_ - kLengthBytes + input.size();
  length_ = seen + std::min(part.at_least_left, std::numeric_limits<std::size_t>::max() - seen);
  if (const auto defect = judge_length()) return fail(*defect);
  if (!input.empty()) {
    if (first) first_ = input.front();
    if (const auto defect = judge_kind(first_)) return fail(*defect);
    if (const auto defect = keep(input)) return fail(*defect);
    received_ += input.size();
    input = {};
  }
  return part.last ? finish() : Result(NeedMore{});
}

std::optional<std::string> Decoder::judge_length() const {
  if (length_ == 0) return "a message of length 0";
  if (length_ > largest(limits_)) {
    return "a message of " + std::to_string(length_) + " bytes where at most " +
           std::to_string(largest(limits_)) + " are accepted";
  }
  return std::nullopt;
}

std::optional<std::string> Decoder::judge_kind(std::byte first) const {
  const std::size_t limit = limit_of(first, limits_);
  if (length_ <= limit) return std::nullopt;
  return "a message of its kind of " + std::to_string(length_) + " bytes where at most " +
         std::to_string(limit) + " are accepted";
}

// Bytes of a frame that will be refused are not kept.
std::optional<std::string> Decoder::keep(std::span<const std::byte> bytes) {
  switch (scan_.take(bytes)) {
    case EnvelopeScan::Verdict::Bad:
      return scan_.defect();
    case EnvelopeScan::Verdict::TooManyPoses:
      std::string().swap(body_);  // assigning would keep the memory
      return std::nullopt;
    case EnvelopeScan::Verdict::Good:
      break;
  }
  // At once for the whole, or growing would copy it again and again.
  if (body_.empty()) body_.reserve(length_);
  body_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return std::nullopt;
}

Decoder::Result Decoder::fail(std::string what) {
  failure_ = Failure{std::move(what)};
  std::string().swap(body_);  // assigning would keep the memory
  return *failure_;
}

Decoder::Result Decoder::finish() {
  const std::string body = std::exchange(body_, std::string());
  EnvelopeScan scan = std::exchange(scan_, EnvelopeScan());
  const std::size_t bytes = std::exchange(received_, 0);
  length_ = 0;
  switch (scan.finish()) {
    case EnvelopeScan::Verdict::Bad:
      return fail(scan.defect());
    case EnvelopeScan::Verdict::TooManyPoses:
      return TooManyPoses{scan.frame_id(), bytes};
    case EnvelopeScan::Verdict::Good:
      break;
  }
  Envelope envelope;
  if (!envelope.ParseFromString(body)) return fail("bytes that are no Envelope");
  return envelope;
}

}  // namespace amalgam::protocol
