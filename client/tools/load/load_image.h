// The picture that a load client sends: a file, or mid grey.
#pragma once

#include <string>

namespace amalgam::load {

struct LoadImage {
  std::string jpeg;
  int width = 0, height = 0;  // pixels
};

LoadImage grey_image(int width, int height);
// Throws std::runtime_error if the file is no JPEG.
LoadImage read_image(const std::string& path);

}  // namespace amalgam::load
