#include "client/sources/environment_message.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "client/sources/fisheye_file.h"
#include "client/sources/jpeg_bytes.h"
#include "protocol/geometry.h"
#include "protocol/limits.h"

namespace amalgam::client {
namespace {

constexpr int kQuality = 95;  // light is extracted from it: artefacts would become lamps

cv::Mat fit_into_limits(const cv::Mat& image) {
  constexpr int kMaxSide = static_cast<int>(protocol::kMaxSide);
  const int longest = std::max(image.cols, image.rows);
  if (longest <= kMaxSide) return image;
  const double scale = static_cast<double>(kMaxSide) / longest;
  const auto scaled = [&](int side) { return std::max(1, static_cast<int>(side * scale + 0.5)); };
  cv::Mat smaller;
  cv::resize(image, smaller, {scaled(image.cols), scaled(image.rows)}, 0, 0, cv::INTER_AREA);
  return smaller;
}

}  // namespace

protocol::Envelope load_environment(const std::filesystem::path& image,
                                    const std::filesystem::path& fisheye) {
  Bytes jpeg = read_picture("environment", image);
  const cv::Mat decoded = decode_image(jpeg);
  if (decoded.empty()) {
    throw std::runtime_error("environment " + image.string() + ": is no image");
  }
  const cv::Mat sent = fit_into_limits(decoded);
  if (sent.size() != decoded.size() || !is_sendable_jpeg(jpeg)) jpeg = encode_jpeg(sent, kQuality);
  if (!is_sendable_jpeg(jpeg)) {
    throw std::runtime_error("environment " + image.string() + ": is too large for one message");
  }
  protocol::Envelope envelope;
  protocol::Environment& environment = *envelope.mutable_environment();
  environment.set_image(jpeg.data(), jpeg.size());
  if (!fisheye.empty()) {
    const FisheyeCalibration calibration = load_fisheye(fisheye, sent.cols, sent.rows);
    *environment.mutable_fisheye() = protocol::to_message(calibration.lens);
    *environment.mutable_fisheye()->mutable_world_from_fisheye() =
        protocol::to_message(calibration.world_from_fisheye);
  }
  return envelope;
}

}  // namespace amalgam::client
