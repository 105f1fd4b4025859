#include "frame/scene_variant.h"

#include <utility>

namespace amalgam::frame {

scene::Scene scene_variant(scene::Scene scene, RendererMode mode) {
  if (mode == RendererMode::Raster) {
    std::erase_if(scene.instances, [&](const scene::Instance& instance) {
      return scene::is_specular(scene.materials[instance.material].kind);
    });
  } else if (mode == RendererMode::Diffuse) {
    for (scene::Material& material : scene.materials) {
      if (!scene::is_specular(material.kind)) continue;
      material.kind = scene::MaterialKind::Diffuse;
      material.metallic = 0.0f;
      material.roughness = 1.0f;
    }
  }
  return scene;
}

}  // namespace amalgam::frame
