#include "scene/gltf/environment_loader.h"

#include <algorithm>
#include <cctype>

#include "codec/exr.h"
#include "codec/picture.h"
#include "codec/radiance_hdr.h"
#include "scene/gltf/check/limits.h"
#include "scene/gltf/sanitize.h"
#include "scene/gltf/scene_folder.h"
#include "scene/light/tone_map.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

// Light probes come in other shapes too (mirror balls, crosses), and no file says so.
void note_shape(const Environment& environment, std::vector<std::string>& notes) {
  const int width = environment.radiance.width(), height = environment.radiance.height();
  if (std::abs(width - 2 * height) <= 1) return;
  notes.push_back("environment: " + std::to_string(width) + "x" + std::to_string(height) +
                  " is not twice as wide as high; read as latitude-longitude all the same");
}

Environment load_unnamed(const std::filesystem::path& path, std::vector<std::string>& notes) {
  const std::string extension = lower_extension(path);
  if (extension == ".jpg" || extension == ".jpeg" || extension == ".png") {
    return environment_from_ldr(codec::decode_picture(read_file(path, kMaxEnvironmentFileBytes)));
  }
  Environment environment;
  if (extension == ".exr") {
    environment.radiance = codec::read_exr(path, &notes);
  } else if (extension == ".hdr") {
    environment.radiance = codec::decode_radiance_hdr(read_file(path, kMaxEnvironmentFileBytes));
  } else {
    throw SceneError("'" + path.filename().string() + "' is none of .exr, .hdr, .jpg, .png");
  }
  const SanitizeCounts counts = sanitize_radiance(environment.radiance);
  if (counts.total() > 0) notes.push_back("environment: " + counts.describe());
  return environment;
}

}  // namespace

Environment load_environment(const std::filesystem::path& path, std::vector<std::string>& notes) {
  try {
    Environment environment = load_unnamed(path, notes);
    note_shape(environment, notes);
    return environment;
  } catch (const codec::PictureError& caught) {
    throw SceneError("'" + path.filename().string() + "': " + caught.what());
  } catch (const codec::ExrError& caught) {
    throw SceneError(caught.what());
  }
}

Environment environment_from_ldr(const common::ImageRgba8& picture) {
  Environment environment;
  environment.low_dynamic_range = true;
  environment.radiance = common::ImageRgb32f(picture.width(), picture.height());
  const auto from = picture.pixels();
  const auto to = environment.radiance.pixels();
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = srgb_decode(common::Rgb8(from[i].x, from[i].y, from[i].z));
  }
  return environment;
}

}  // namespace amalgam::scene
