#include "frame/fingerprint.h"

#include <gtest/gtest.h>

namespace amalgam::frame {
namespace {

TEST(Fingerprint, NamesTheSceneAndTheSettingsThatDecideBytes) {
  const std::string scene = AMALGAM_SOURCE_DIR "/deploy/scenes/mirror.gltf";
  RendererSettings settings;
  settings.samples_per_pixel = 4;
  settings.jpeg_quality = 70;
  settings.threads = 3;
  const FrameService::Fingerprint fingerprint = fingerprint_of(scene, settings);
  EXPECT_EQ(fingerprint.scene, "mirror.gltf");
  EXPECT_EQ(fingerprint.options, "--samples 4, jpeg_quality is 70");
  EXPECT_EQ(fingerprint.scene_hash.size(), 64u);
  EXPECT_EQ(fingerprint_of(scene, {}).options, "");
  EXPECT_EQ(fingerprint_of("gone.gltf", {}).scene_hash, "");
}

}  // namespace
}  // namespace amalgam::frame
