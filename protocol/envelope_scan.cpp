#include "protocol/envelope_scan.h"

#include <algorithm>

#include "protocol/limits.h"

namespace amalgam::protocol {
namespace {

// Of the wire format of Protocol Buffers.
constexpr std::uint32_t kVarint = 0, kFixed64 = 1, kLengthDelimited = 2, kFixed32 = 5;
constexpr int kMaxVarintBytes = 10;

}  // namespace

EnvelopeScan::Verdict EnvelopeScan::take(std::span<const std::byte> bytes) {
  while (!bytes.empty() && verdict_ == Verdict::Good) {
    std::size_t taken = 1;
    if (expect_ == Expect::Skip) {
      taken = static_cast<std::size_t>(std::min<std::uint64_t>(skip_, bytes.size()));
      skip_ -= taken;
    }
    const bool image = expect_ == Expect::Skip && skips_image_;
    if (!image) small_bytes_ += taken;
    if (small_bytes_ > kMaxControlBytes) {
      bad("a message with more beside its image than a message without one may have");
      break;
    }
    if (inside_ && taken > *inside_) {
      bad("bytes that are no Envelope");
      break;
    }
    if (inside_) *inside_ -= taken;
    if (expect_ == Expect::Skip) {
      if (skip_ == 0) on_value_end();
    } else {
      take_byte(std::to_integer<unsigned>(bytes.front()));
    }
    bytes = bytes.subspan(taken);
  }
  return verdict_;
}

EnvelopeScan::Verdict EnvelopeScan::finish() {
  const bool complete = expect_ == Expect::Tag && varint_bytes_ == 0 && !inside_;
  if (verdict_ == Verdict::Good && !complete) bad("bytes that are no Envelope");
  return verdict_;
}

void EnvelopeScan::take_byte(unsigned byte) {
  if (varint_bytes_ == kMaxVarintBytes) return bad("bytes that are no Envelope");
  varint_ |= static_cast<std::uint64_t>(byte & 0x7fu) << (7 * varint_bytes_);
  ++varint_bytes_;
  if ((byte & 0x80u) != 0) return;
  varint_bytes_ = 0;
  switch (expect_) {
    case Expect::Tag:
      on_tag();
      break;
    case Expect::Varint:
      if (body_ == Envelope::kCameraFrameFieldNumber && inside_ &&
          field_ == CameraFrame::kFrameIdFieldNumber) {
        frame_id_ = varint_;
      }
      on_value_end();
      break;
    case Expect::Length:
      on_length();
      break;
    case Expect::Skip:
      break;
  }
  varint_ = 0;
}

void EnvelopeScan::on_tag() {
  field_ = static_cast<std::uint32_t>(varint_ >> 3);
  wire_type_ = static_cast<std::uint32_t>(varint_ & 7);
  skips_image_ = false;
  if (field_ == 0) return bad("bytes that are no Envelope");
  switch (wire_type_) {
    case kVarint:
      expect_ = Expect::Varint;
      return;
    case kLengthDelimited:
      expect_ = Expect::Length;
      return;
    case kFixed64:
    case kFixed32:
      expect_ = Expect::Skip;
      skip_ = wire_type_ == kFixed64 ? 8 : 4;
      return;
    default:
      return bad("bytes that are no Envelope");
  }
}

void EnvelopeScan::on_length() {
  if (!inside_ && field_ <= static_cast<std::uint32_t>(Envelope::kDrainingFieldNumber)) {
    if (body_ != 0) return bad("an Envelope with two bodies");
    body_ = static_cast<int>(field_);
    inside_ = varint_;
    expect_ = Expect::Tag;
    if (varint_ == 0) inside_.reset();
    return;
  }
  const bool is_marker =
      field_ == CameraFrame::kPosesFieldNumber || field_ == CameraFrame::kCornersFieldNumber;
  if (inside_ && body_ == Envelope::kCameraFrameFieldNumber && is_marker &&
      ++markers_ > kMaxPoses) {
    verdict_ = Verdict::TooManyPoses;
    return;
  }
  skips_image_ = inside_ && is_image();
  skip_ = varint_;
  expect_ = Expect::Skip;
  if (skip_ == 0) on_value_end();
}

bool EnvelopeScan::is_image() const {
  switch (body_) {
    case Envelope::kCameraFrameFieldNumber:
      return field_ == CameraFrame::kJpegFieldNumber;
    case Envelope::kEnvironmentFieldNumber:
      return field_ == Environment::kImageFieldNumber;
    case Envelope::kCompositeFieldNumber:
      return field_ == Composite::kJpegFieldNumber;
    default:
      return false;
  }
}

void EnvelopeScan::on_value_end() {
  expect_ = Expect::Tag;
  if (inside_ && *inside_ == 0) inside_.reset();
}

void EnvelopeScan::bad(const char* why) {
  verdict_ = Verdict::Bad;
  defect_ = why;
}

}  // namespace amalgam::protocol
