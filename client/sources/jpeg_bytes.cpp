#include "client/sources/jpeg_bytes.h"

#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "common/whole_file.h"
#include "protocol/limits.h"

namespace amalgam::client {
namespace {

constexpr unsigned char kMarkerPrefix = 0xFF;
constexpr unsigned char kStartOfImage = 0xD8;
constexpr unsigned char kBaselineFrame = 0xC0;  // SOF0
constexpr unsigned char kStartOfScan = 0xDA;
// Poses and field headers share the message with the image.
constexpr std::size_t kMessageOverhead = 16 * 1024;

// The body of the SOF0 segment, or nothing if the frame is of another kind.
std::optional<std::span<const unsigned char>> baseline_header(
    std::span<const unsigned char> bytes) {
  if (bytes.size() < 4 || bytes[0] != kMarkerPrefix || bytes[1] != kStartOfImage) return {};
  std::size_t at = 2;
  while (at + 4 <= bytes.size()) {
    const unsigned char marker = bytes[at + 1];
    if (bytes[at] != kMarkerPrefix || marker == kMarkerPrefix || marker == 0) {
      ++at;  // a fill byte, or a stray one, which decoders skip
      continue;
    }
    const std::size_t length = static_cast<std::size_t>(bytes[at + 2]) << 8 | bytes[at + 3];
    if (length < 2 || at + 2 + length > bytes.size() || marker == kStartOfScan) return {};
    if (marker == kBaselineFrame) return bytes.subspan(at + 4, length - 2);
    // C4 and CC are tables; the rest of C1..CF are the other kinds of frame (C8 is reserved).
    const bool other_frame = marker >= 0xC1 && marker <= 0xCF && marker != 0xC4 && marker != 0xCC;
    if (other_frame) return {};
    at += 2 + length;
  }
  return {};
}

}  // namespace

bool is_sendable_jpeg(std::span<const unsigned char> bytes) {
  if (bytes.size() + kMessageOverhead > protocol::kMaxCameraFrameBytes) return false;
  const auto header = baseline_header(bytes);
  if (!header || header->size() < 6 || (*header)[0] != 8) return false;
  const std::size_t components = (*header)[5];
  if (components != 1 && components != 3) return false;
  if (header->size() < 6 + 3 * components) return false;
  const auto sampling = [&](std::size_t component) { return (*header)[6 + 3 * component + 1]; };
  if (components == 1) return true;
  const bool luma = sampling(0) == 0x11 || sampling(0) == 0x21 || sampling(0) == 0x22;
  return luma && sampling(1) == 0x11 && sampling(2) == 0x11;
}

Bytes read_picture(const char* kind, const std::filesystem::path& file) {
  try {
    const std::string bytes = common::read_whole_file(file, common::kMostPictureBytes);
    return {bytes.begin(), bytes.end()};
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(kind) + " " + error.what());
  }
}

Bytes encode_jpeg(const cv::Mat& bgr, int quality) {
  Bytes jpeg;
  if (!cv::imencode(".jpg", bgr, jpeg, {cv::IMWRITE_JPEG_QUALITY, quality})) {
    throw std::runtime_error("an image cannot be encoded as JPEG");
  }
  return jpeg;
}

cv::Mat decode_image(std::span<const unsigned char> bytes) {
  if (bytes.empty()) return {};
  auto* data = const_cast<unsigned char*>(bytes.data());  // cv::Mat has no view of constant bytes
  const cv::Mat view(1, static_cast<int>(bytes.size()), CV_8UC1, data);
  try {
    return cv::imdecode(view, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace amalgam::client
