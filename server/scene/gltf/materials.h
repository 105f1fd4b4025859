// glTF materials and textures resolved into Amalgam's: design, "Scenes".
//
//   transmissionFactor >= 0.5             Dielectric; thin unless KHR_materials_volume gives a
//                                         thickness > 0 (then sigma_a = -ln(color) / distance)
//   transmissionFactor >= 0.5, ior = 0    a white Mirror that reflects everything
//   metallic >= 0.5, roughness <= 0.2     Mirror, F0 = base color
//   anything else                         Diffuse (Phong)
//
// The factors alone decide the kind. A metallic-roughness texture changes a Diffuse material's
// Phong terms from point to point; mirrors do not read it. Light that glass does not transmit
// (transmission texture or factor below 1) is scattered back by a surface of the base color:
// Lambertian, or Phong if it is rough.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/model.h"
#include "scene/gltf/textures.h"
#include "scene/scene.h"

namespace amalgam::scene {

struct ResolvedMaterials {
  std::vector<Material> materials;  // the file's, then the default one
  // For each material, what Mesh::uvs and Mesh::second_uvs of its meshes hold: at most two uses.
  std::vector<std::vector<TextureUse>> texture_uses;
};

// Decodes the pictures that are used and adds them to textures. Adds to notes. Throws SceneError.
ResolvedMaterials resolve_materials(const GltfModel& gltf, std::vector<Texture>& textures,
                                    std::vector<std::string>& notes);

}  // namespace amalgam::scene
