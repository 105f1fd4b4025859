// Decompresses a glTF file's vertices and indices: EXT_meshopt_compression and
// KHR_draco_mesh_compression.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/model.h"

namespace amalgam::scene {

// The buffer views of the model that are compressed with meshoptimizer then refer to new buffers
// with the plain data. The document has passed check_gltf(). Throws SceneError for damaged data.
void decompress_meshopt(const JsonCursor& root, tinygltf::Model& model);

// The primitives of the model that are compressed with Draco then refer to new accessors. Throws
// SceneError for damaged data.
void decompress_draco(const JsonCursor& root, tinygltf::Model& model);

}  // namespace amalgam::scene
