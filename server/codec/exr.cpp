#include "codec/exr.h"

#include <ImathBox.h>
#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <algorithm>
#include <exception>
#include <new>
#include <system_error>

namespace amalgam::codec {
namespace {

using Channels = std::vector<std::pair<std::string, common::Image32f>>;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw ExrError(path.string() + ": " + why);
}

// OpenEXR addresses pixels from the data window's origin, which need not be (0, 0).
Imf::Slice slice_of(common::Image32f& image, const Imath::Box2i& window) {
  return Imf::Slice::Make(Imf::FLOAT, image.data(), window, sizeof(float),
                          sizeof(float) * static_cast<std::size_t>(image.width()));
}

// Width and height of the data window, if they are within the limits.
std::pair<int, int> checked_size(const std::filesystem::path& path, const Imath::Box2i& window) {
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  if (width < 1 || height < 1 || width > kMaxExrSide || height > kMaxExrSide ||
      width * height > kMaxExrPixels) {
    fail(path, "image size " + std::to_string(width) + "x" + std::to_string(height) +
                   " is outside the limits (16384 a side, 64 Mpixel)");
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

std::map<std::string, common::Image32f> read_unguarded(const std::filesystem::path& path) {
  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  const auto [width, height] = checked_size(path, window);

  constexpr std::size_t kMaxChannels = 64;
  std::map<std::string, common::Image32f> channels;
  Imf::FrameBuffer frame_buffer;
  const Imf::ChannelList& list = file.header().channels();
  for (auto it = list.begin(); it != list.end(); ++it) {
    if (channels.size() == kMaxChannels) fail(path, "more than 64 channels");
    if (it.channel().xSampling != 1 || it.channel().ySampling != 1) {
      fail(path, std::string("channel ") + it.name() + " is sub-sampled");
    }
    if (std::int64_t{width} * height * static_cast<std::int64_t>(channels.size() + 1) >
        4 * kMaxExrPixels) {
      fail(path, "its channels together are larger than 256 Mpixel");
    }
    common::Image32f& image =
        channels.emplace(it.name(), common::Image32f(width, height)).first->second;
    frame_buffer.insert(it.name(), slice_of(image, window));
  }
  if (channels.empty()) fail(path, "no channels");
  file.setFrameBuffer(frame_buffer);
  file.readPixels(window.min.y, window.max.y);
  return channels;
}

}  // namespace

std::map<std::string, common::Image32f> read_exr_channels(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) fail(path, error.message());
  if (bytes > kMaxExrBytes) fail(path, "file is larger than 512 MiB");
  Imf::Header::setMaxImageSize(kMaxExrSide, kMaxExrSide);
  Imf::Header::setMaxTileSize(kMaxExrSide, kMaxExrSide);
  try {
    return read_unguarded(path);
  } catch (const ExrError&) {
    throw;
  } catch (const std::exception& caught) {
    std::string why = caught.what();
    std::replace(why.begin(), why.end(), '\n', ' ');
    fail(path, "not a readable OpenEXR image: " + why);
  }
}

common::ImageRgb32f read_exr(const std::filesystem::path& path) {
  const auto channels = read_exr_channels(path);
  const common::Image32f& any = channels.begin()->second;
  common::ImageRgb32f image(any.width(), any.height());
  bool found = false;
  const auto copy = [&](const std::string& name, int component) {
    const auto channel = channels.find(name);
    if (channel == channels.end()) return;
    found = true;
    const auto from = channel->second.pixels();
    const auto to = image.pixels();
    for (std::size_t i = 0; i < to.size(); ++i) to[i][component] = from[i];
  };
  copy("R", 0);
  copy("G", 1);
  copy("B", 2);
  if (!found) {
    for (int component = 0; component < 3; ++component) copy("Y", component);
  }
  if (!found) fail(path, "it has none of the channels R, G, B, Y");
  return image;
}

void write_exr(const std::filesystem::path& path, const Channels& channels) {
  if (channels.empty() || channels.front().second.empty()) fail(path, "nothing to write");
  const glm::ivec2 size = channels.front().second.size();
  try {
    Imf::Header header(size.x, size.y);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame_buffer;
    for (const auto& [name, image] : channels) {
      if (image.size() != size) fail(path, "channel " + name + " has another size than the first");
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      // OpenEXR's slices are not const, but writing only reads them.
      auto& writable = const_cast<common::Image32f&>(image);
      frame_buffer.insert(name, slice_of(writable, header.dataWindow()));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame_buffer);
    file.writePixels(size.y);
  } catch (const ExrError&) {
    throw;
  } catch (const std::exception& caught) {
    fail(path, std::string("cannot write: ") + caught.what());
  }
}

namespace {

template <typename Pixel>
void write_components(const std::filesystem::path& path, const common::Image<Pixel>& image,
                      const char* names) {
  Channels channels;
  for (int component = 0; component < Pixel::length(); ++component) {
    common::Image32f plane(image.width(), image.height());
    const auto from = image.pixels();
    const auto to = plane.pixels();
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i][component];
    channels.emplace_back(std::string(1, names[component]), std::move(plane));
  }
  write_exr(path, channels);
}

}  // namespace

void write_exr(const std::filesystem::path& path, const common::ImageRgb32f& image) {
  write_components(path, image, "RGB");
}

void write_exr(const std::filesystem::path& path, const common::ImageRgba32f& image) {
  write_components(path, image, "RGBA");
}

void write_exr(const std::filesystem::path& path, const common::Image32f& image) {
  write_exr(path, Channels{{"Y", image}});
}

}  // namespace amalgam::codec
