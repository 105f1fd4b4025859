#include "support/damaged_jpeg.h"

#include <stdexcept>

namespace amalgam::test_support {

std::size_t frame_marker(const JpegBytes& jpeg) {
  for (std::size_t i = 2; i + 3 < jpeg.size();) {
    const int code = std::to_integer<int>(jpeg[i + 1]);
    if (code == 0xC0) return i + 1;
    i += 2 + static_cast<std::size_t>(std::to_integer<int>(jpeg[i + 2]) * 256 +
                                      std::to_integer<int>(jpeg[i + 3]));
  }
  throw std::invalid_argument("a JPEG without a baseline frame header");
}

JpegBytes with_size(JpegBytes jpeg, int width, int height) {
  std::byte* const size = &jpeg[frame_marker(jpeg) + 4];
  size[0] = static_cast<std::byte>(height / 256);
  size[1] = static_cast<std::byte>(height % 256);
  size[2] = static_cast<std::byte>(width / 256);
  size[3] = static_cast<std::byte>(width % 256);
  return jpeg;
}

JpegBytes with_more_scans(JpegBytes jpeg, int more) {
  jpeg.resize(jpeg.size() - 2);  // the end marker
  const JpegBytes scan{std::byte{0xFF}, std::byte{0xDA}, std::byte{0}, std::byte{2}};
  for (int i = 0; i < more; ++i) jpeg.insert(jpeg.end(), scan.begin(), scan.end());
  return jpeg;
}

}  // namespace amalgam::test_support
