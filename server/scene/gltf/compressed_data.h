// Decompresses a glTF file's vertices and indices: EXT_meshopt_compression and
// KHR_draco_mesh_compression.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/check/limits.h"
#include "scene/gltf/model.h"

namespace amalgam::scene {

// The buffer views of the model that are compressed with meshoptimizer then refer to new buffers
// with the plain data. The document has passed check_gltf(). Throws SceneError for damaged data.
void decompress_meshopt(const JsonCursor& root, tinygltf::Model& model);

// Of all primitives together.
struct DracoLimits {
  std::size_t vertices = kMaxVertices;
  std::size_t triangles = kMaxTriangles;
  std::size_t bytes = kMaxDracoBytes;  // of their attributes, decompressed
};

// The primitives of the model that are compressed with Draco then refer to new accessors. Throws
// SceneError for damaged data, and for more than the limits.
void decompress_draco(const JsonCursor& root, tinygltf::Model& model,
                      const DracoLimits& limits = {});

}  // namespace amalgam::scene
