// glTF materials and textures resolved into Amalgam's: design, "Scenes".
//
//   transmissionFactor >= 0.5                      Dielectric; thin unless KHR_materials_volume
//   gives a
//                                                  thickness > 0 (then sigma_a = -ln(colour) /
//                                                  distance)
//   metallic >= 0.5 and roughness <= 0.2           Mirror, F0 = base colour
//   anything else                                  Diffuse (Phong)
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/gltf_model.h"
#include "scene/scene.h"

namespace amalgam::scene {

// How a primitive of this material finds its texture coordinates (KHR_texture_transform is applied
// to the coordinates when the mesh is read).
struct TextureUse {
  int uv_set = 0;  // n of TEXCOORD_n
  glm::vec2 offset{0.0f};
  glm::vec2 scale{1.0f};
  float rotation = 0.0f;  // radians, counter-clockwise
};

struct ResolvedMaterials {
  std::vector<Material> materials;       // one for each of the file, then the default one
  std::vector<TextureUse> texture_uses;  // as many
};

// Decodes only pictures that a base colour uses; adds those to textures. Adds to notes. Throws
// SceneError.
ResolvedMaterials resolve_materials(const GltfModel& gltf, std::vector<Texture>& textures,
                                    std::vector<std::string>& notes);

}  // namespace amalgam::scene
