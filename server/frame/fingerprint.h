// What decides the bytes of composites besides what clients send.
#pragma once

#include <filesystem>

#include "frame/frame.h"
#include "frame/renderer_settings.h"

namespace amalgam::frame {

// All but the hardware, which is known once a renderer is made. Without a scene_hash if the scene's
// files cannot be read any more.
FrameService::Fingerprint fingerprint_of(const std::filesystem::path& scene,
                                         const RendererSettings& settings);

}  // namespace amalgam::frame
