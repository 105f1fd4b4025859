// Pictures for the client: reads them, tests what can be sent unchanged, encodes and decodes.
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <span>

#include "client/sources/camera_source.h"

namespace amalgam::client {

// Whether a server accepts it: baseline, 8 bits, grey or three components subsampled as 4:4:4,
// 4:2:2 or 4:2:0, and small enough for one message. Reads headers only.
bool is_sendable_jpeg(std::span<const unsigned char> bytes);

// A picture's file. kind: of picture, for the error. Throws std::runtime_error with one line.
Bytes read_picture(const char* kind, const std::filesystem::path& file);

// quality 1..100. Throws std::runtime_error if the image cannot be encoded.
Bytes encode_jpeg(const cv::Mat& bgr, int quality);

// As BGR. Ignores orientation tags, because the server does too and markers must match its pixels.
// An empty image if the bytes are no image.
cv::Mat decode_image(std::span<const unsigned char> bytes);

}  // namespace amalgam::client
