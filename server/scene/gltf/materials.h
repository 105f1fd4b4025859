// glTF materials and textures resolved into Amalgam's: design, "Scenes".
//
//   transmissionFactor >= 0.5                      Dielectric; thin unless KHR_materials_volume
//   gives a
//                                                  thickness > 0 (then sigma_a = -ln(color) /
//                                                  distance)
//                                                  ior = 0: a white Mirror, reflects everything
//   metallic >= 0.5 and roughness <= 0.2           Mirror, F0 = base color
//   anything else                                  Diffuse (Phong)
//
// The factors alone decide the kind, textures do not: a metallic-roughness texture changes a
// Diffuse material's Phong terms from point to point, and is not read for mirrors, which are smooth
// throughout. Where a transmission texture (or factor) lets less than everything through glass, the
// rest is scattered back by a Lambertian surface of the base color.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/model.h"
#include "scene/gltf/textures.h"
#include "scene/scene.h"

namespace amalgam::scene {

struct ResolvedMaterials {
  std::vector<Material> materials;  // one for each of the file, then the default one
  // As many: what Mesh::uvs and Mesh::second_uvs are for meshes of the material, at most two.
  std::vector<std::vector<TextureUse>> texture_uses;
};

// Decodes only pictures that are used; adds those to textures. Adds to notes. Throws
// SceneError.
ResolvedMaterials resolve_materials(const GltfModel& gltf, std::vector<Texture>& textures,
                                    std::vector<std::string>& notes);

}  // namespace amalgam::scene
