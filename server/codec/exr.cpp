#include "codec/exr.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>

#include <exception>

#include "common/whole_file.h"

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

}  // namespace

void write_exr(const std::filesystem::path& path, const Channels& channels,
               const std::string& comments) {
  if (channels.empty() || channels.front().second.empty()) fail(path, "nothing to write");
  const glm::ivec2 size = channels.front().second.size();
  try {
    Imf::Header header(size.x, size.y);
    header.compression() = Imf::ZIP_COMPRESSION;
    if (!comments.empty()) Imf::addComments(header, comments);
    Imf::FrameBuffer frame_buffer;
    for (const auto& [name, image] : channels) {
      if (image.size() != size) fail(path, "channel " + name + " has another size than the first");
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      // OpenEXR's slices are not const, but writing only reads them.
      auto& writable = const_cast<common::Image32f&>(image);
      frame_buffer.insert(name, slice_of(writable, header.dataWindow()));
    }
    common::write_whole_file(path, [&](const std::filesystem::path& part) {
      Imf::OutputFile file(part.c_str(), header);
      file.setFrameBuffer(frame_buffer);
      file.writePixels(size.y);
    });
  } catch (const ExrError&) {
    throw;
  } catch (const std::exception& caught) {
    fail(path, std::string("cannot write: ") + caught.what());
  }
}

namespace {

template <typename Pixel>
void write_components(const std::filesystem::path& path, const common::Image<Pixel>& image,
                      const char* names, const std::string& comments) {
  Channels channels;
  for (int component = 0; component < Pixel::length(); ++component) {
    common::Image32f plane(image.width(), image.height());
    const auto from = image.pixels();
    const auto to = plane.pixels();
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i][component];
    channels.emplace_back(std::string(1, names[component]), std::move(plane));
  }
  write_exr(path, channels, comments);
}

}  // namespace

void write_exr(const std::filesystem::path& path, const common::ImageRgb32f& image,
               const std::string& comments) {
  write_components(path, image, "RGB", comments);
}

void write_exr(const std::filesystem::path& path, const common::ImageRgba32f& image,
               const std::string& comments) {
  write_components(path, image, "RGBA", comments);
}

void write_exr(const std::filesystem::path& path, const common::Image32f& image,
               const std::string& comments) {
  write_exr(path, Channels{{"Y", image}}, comments);
}

}  // namespace amalgam::codec
