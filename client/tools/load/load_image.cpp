#include "client/tools/load/load_image.h"

#include <turbojpeg.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <vector>

namespace amalgam::load {
namespace {

struct Destroy {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, Destroy>;

}  // namespace

LoadImage grey_image(int width, int height) {
  constexpr unsigned char kMidGrey = 128;
  constexpr int kQuality = 85;
  const auto pixel_count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::vector<unsigned char> pixels(pixel_count * 3, kMidGrey);
  const Handle compressor(tjInitCompress());
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  if (tjCompress2(compressor.get(), pixels.data(), width, 0, height, TJPF_RGB, &bytes, &size,
                  TJSAMP_420, kQuality, 0) != 0) {
    throw std::runtime_error(tjGetErrorStr2(compressor.get()));
  }
  LoadImage image{std::string(reinterpret_cast<char*>(bytes), size), width, height};
  tjFree(bytes);
  return image;
}

LoadImage read_image(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  LoadImage image;
  image.jpeg.assign(std::istreambuf_iterator<char>(file), {});
  const Handle decompressor(tjInitDecompress());
  int subsampling = 0, color_space = 0;
  if (tjDecompressHeader3(
          decompressor.get(), reinterpret_cast<const unsigned char*>(image.jpeg.data()),
          image.jpeg.size(), &image.width, &image.height, &subsampling, &color_space) != 0) {
    throw std::runtime_error(path + ": " + tjGetErrorStr2(decompressor.get()));
  }
  return image;
}

}  // namespace amalgam::load
