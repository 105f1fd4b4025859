// Which picture of a glTF texture is read, where extensions offer others beside PNG and JPEG.
#pragma once

#include <cstddef>
#include <optional>

#include "scene/gltf/check/json_value.h"

namespace amalgam::scene {

// An index into the images: EXT_texture_webp's, or else the texture's own; nothing if it has none.
// Fails for a texture that only KHR_texture_basisu gives a picture, with the command that converts.
std::optional<std::size_t> texture_source(const JsonCursor& texture);

}  // namespace amalgam::scene
