// What tinygltf is given of a document that has passed our checks.
#pragma once

#include <string>
#include <string_view>

namespace amalgam::scene {

// The same JSON without buffers, pictures, and what is not drawn (cameras, skins, animations, morph
// targets), and without what tinygltf is stricter about than we: empty lists, strides, bounds that
// are no numbers, integers written as 3.0, indices (which may be compressed).
std::string reduced_document(std::string_view json);

}  // namespace amalgam::scene
