#include "frame/fingerprint.h"

#include <string>

#include "frame/settings_options.h"
#include "scene/gltf/scene_hash.h"
#include "scene/scene_error.h"

namespace amalgam::frame {
namespace {

// All settings that a picture depends on, as options where there are some.
std::string text_of(RendererSettings settings) {
  settings.threads = RendererSettings().threads;  // images have the same bits for any number
  std::string text;
  for (const std::string& word : settings_options(settings)) {
    text.append(text.empty() ? "" : " ").append(word);
  }
  const std::string others = settings_without_options(settings);
  if (!others.empty()) text.append(text.empty() ? "" : ", ").append(others);
  return text;
}

std::string hash_of(const std::filesystem::path& scene) {
  try {
    return scene::scene_hash(scene);
  } catch (const scene::SceneError&) {
    return "";
  }
}

}  // namespace

FrameService::Fingerprint fingerprint_of(const std::filesystem::path& scene,
                                         const RendererSettings& settings) {
  return {.scene = scene.filename().string(),
          .scene_hash = hash_of(scene),
          .options = text_of(settings),
          .hardware = ""};
}

}  // namespace amalgam::frame
