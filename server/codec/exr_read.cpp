#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfEnvmap.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <system_error>

#include "codec/color_space.h"
#include "codec/exr.h"
#include "codec/exr_cube.h"
#include "common/one_line.h"

namespace amalgam::codec {
namespace {

using ChannelMap = std::map<std::string, common::Image32f>;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw ExrError(path.string() + ": " + why);
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

std::vector<std::string> names_of(const Imf::Header& header) {
  std::vector<std::string> names;
  const Imf::ChannelList& list = header.channels();
  for (auto it = list.begin(); it != list.end(); ++it) names.emplace_back(it.name());
  return names;
}

ChannelMap read_channels(const std::filesystem::path& path, Imf::InputPart& part,
                         const std::vector<std::string>& names) {
  const Imath::Box2i window = part.header().dataWindow();
  const auto [width, height] = checked_size(path, window);
  constexpr std::size_t kMaxChannels = 64;
  if (names.empty()) fail(path, "no channels");
  if (names.size() > kMaxChannels) fail(path, "more than 64 channels");
  if (std::int64_t{width} * height * static_cast<std::int64_t>(names.size()) > 4 * kMaxExrPixels) {
    fail(path, "its channels together are larger than 256 Mpixel");
  }
  ChannelMap channels;
  Imf::FrameBuffer frame_buffer;
  for (const std::string& name : names) {
    const Imf::Channel& channel = part.header().channels()[name.c_str()];
    if (channel.xSampling != 1 || channel.ySampling != 1) {
      fail(path, "channel " + name + " is sub-sampled");
    }
    common::Image32f& image = channels.emplace(name, common::Image32f(width, height)).first->second;
    // OpenEXR addresses pixels from the data window's origin, which need not be (0, 0).
    frame_buffer.insert(name,
                        Imf::Slice::Make(Imf::FLOAT, image.data(), window, sizeof(float),
                                         sizeof(float) * static_cast<std::size_t>(image.width())));
  }
  part.setFrameBuffer(frame_buffer);
  part.readPixels(window.min.y, window.max.y);
  return channels;
}

// Opens the file and gives it to read(); OpenEXR's exceptions become ours.
template <typename Read>
auto with_file(const std::filesystem::path& path, Read read) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) fail(path, error.message());
  if (bytes > kMaxExrBytes) fail(path, "file is larger than 512 MiB");
  Imf::Header::setMaxImageSize(kMaxExrSide, kMaxExrSide);
  Imf::Header::setMaxTileSize(kMaxExrSide, kMaxExrSide);
  try {
    Imf::MultiPartInputFile file(path.c_str());
    return read(file);
  } catch (const ExrError&) {
    throw;
  } catch (const std::exception& caught) {
    fail(path, "not a readable OpenEXR image: " + common::one_line(caught.what()));
  }
}

// What to read of a part: the names of R, G and B, which may be equal or, for R, G or B alone,
// empty.
struct Choice {
  std::array<std::string, 3> rgb;
  std::string note;
};

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The layers with R, G and B: "ViewLayer.Combined" of "ViewLayer.Combined.R".
std::vector<std::string> color_layers(const std::vector<std::string>& names) {
  std::vector<std::string> layers;
  for (const std::string& name : names) {
    if (!name.ends_with(".R")) continue;
    const std::string layer = name.substr(0, name.size() - 2);
    if (has(names, layer + ".G") && has(names, layer + ".B")) layers.push_back(layer);
  }
  return layers;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::optional<Choice> choose(const std::filesystem::path& path,
                             const std::vector<std::string>& names) {
  if (has(names, "R") || has(names, "G") || has(names, "B")) {
    Choice choice;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string name(1, "RGB"[i]);
      if (has(names, name)) choice.rgb[i] = name;
    }
    return choice;
  }
  std::vector<std::string> layers = color_layers(names);
  if (layers.size() > 1) {
    const auto combined = [](const std::string& layer) {
      return layer == "Combined" || layer.ends_with(".Combined");
    };
    std::vector<std::string> main;
    std::copy_if(layers.begin(), layers.end(), std::back_inserter(main), combined);
    if (main.size() != 1) fail(path, "has several layers and no main one: " + joined(layers));
    layers = main;
  }
  if (!layers.empty()) {
    const std::string& layer = layers.front();
    return Choice{{layer + ".R", layer + ".G", layer + ".B"}, "its layer " + layer + " is read"};
  }
  const bool has_chroma = has(names, "RY") || has(names, "BY");
  if (has(names, "Y")) {
    return Choice{{"Y", "Y", "Y"},
                  has_chroma ? "its colors (RY, BY) are not supported; read as grey" : ""};
  }
  return std::nullopt;
}

common::ImageRgb32f rgb_of(const ChannelMap& channels, const Choice& choice) {
  const common::Image32f& any = channels.begin()->second;
  common::ImageRgb32f image(any.width(), any.height());
  for (std::size_t component = 0; component < 3; ++component) {
    const auto channel = channels.find(choice.rgb[component]);
    if (channel == channels.end()) continue;
    const auto from = channel->second.pixels();
    const auto to = image.pixels();
    for (std::size_t i = 0; i < to.size(); ++i) {
      to[i][static_cast<int>(component)] = from[i];
    }
  }
  return image;
}

Chromaticities chromaticities_of(const Imf::Chromaticities& from) {
  return {{from.red.x, from.red.y},
          {from.green.x, from.green.y},
          {from.blue.x, from.blue.y},
          {from.white.x, from.white.y}};
}

// Stated chromaticities, if they are not those of Rec. 709 in float.
std::optional<Chromaticities> other_space(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return std::nullopt;
  const Imf::Chromaticities& stated = Imf::chromaticities(header);
  constexpr float kRounding = 1e-4f;
  const Imf::Chromaticities rec709;
  const bool same = stated.red.equalWithAbsError(rec709.red, kRounding) &&
                    stated.green.equalWithAbsError(rec709.green, kRounding) &&
                    stated.blue.equalWithAbsError(rec709.blue, kRounding) &&
                    stated.white.equalWithAbsError(rec709.white, kRounding);
  if (same) return std::nullopt;
  return chromaticities_of(stated);
}

common::ImageRgb32f read_colors(const std::filesystem::path& path, Imf::InputPart& part,
                                const Choice& choice, std::vector<std::string>& notes) {
  std::vector<std::string> names;
  for (const std::string& name : choice.rgb) {
    if (!name.empty() && !has(names, name)) names.push_back(name);
  }
  common::ImageRgb32f image = rgb_of(read_channels(path, part, names), choice);
  const std::string file = path.filename().string() + ": ";
  if (!choice.note.empty()) notes.push_back(file + choice.note);
  const bool is_grey = choice.rgb[0] == "Y";
  const auto space = other_space(part.header());
  if (space && !is_grey) {
    const auto matrix = rec709_from(*space);
    if (!matrix) fail(path, "its chromaticities span no color space");
    transform_colors(image, *matrix);
    notes.push_back(file + "converted from its chromaticities to Rec. 709");
  }
  if (Imf::hasEnvmap(part.header()) && Imf::envmap(part.header()) == Imf::ENVMAP_CUBE) {
    auto map = equirectangular_from_cube(image);
    if (!map) fail(path, "is a cube map that is not six times as high as wide");
    image = *std::move(map);
    notes.push_back(file + "converted from a cube map");
  }
  return image;
}

}  // namespace

ChannelMap read_exr_channels(const std::filesystem::path& path) {
  return with_file(path, [&](Imf::MultiPartInputFile& file) {
    Imf::InputPart part(file, 0);
    return read_channels(path, part, names_of(part.header()));
  });
}

common::ImageRgb32f read_exr(const std::filesystem::path& path, std::vector<std::string>* notes) {
  return with_file(path, [&](Imf::MultiPartInputFile& file) {
    std::vector<std::string> unread, found;
    for (int i = 0; i < file.parts(); ++i) {
      const Imf::Header& header = file.header(i);
      const auto names = names_of(header);
      found.insert(found.end(), names.begin(), names.end());
      if (header.hasType() && Imf::isDeepData(header.type())) continue;
      const auto choice = choose(path, names);
      if (!choice) continue;
      Imf::InputPart part(file, i);
      return read_colors(path, part, *choice, notes ? *notes : unread);
    }
    fail(path, "it has none of the channels R, G, B, Y, but " + joined(found));
  });
}

}  // namespace amalgam::codec
