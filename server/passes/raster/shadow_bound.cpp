#include "passes/raster/shadow_bound.h"

#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

namespace amalgam::passes {
namespace {

using SharedCells = std::shared_ptr<const CasterCells>;

class CellsBound : public trace::ShadowBound {
 public:
  CellsBound(SharedLights lights, std::vector<SharedCells> casters)
      : lights_(std::move(lights)), casters_(std::move(casters)) {}

  bool may_be_shaded(std::size_t light, const glm::vec3& point) const override {
    const gl::GpuLight& gpu = lights_->layout.gpu_lights[light];
    // Only directional lights are tested. Others are few, and near them a cell covers too much to
    // help.
    if (gpu.kind != static_cast<std::uint32_t>(scene::Light::Kind::Directional)) return true;
    const glm::vec3 clip(gpu.clip_from_world * glm::vec4(point, 1.0f));
    const glm::dvec2 at = 0.5 * glm::dvec2(clip) + 0.5;
    // A map samples casters at texel centres only. This many texels, sideways and in depth, cover
    // the parts that it misses.
    constexpr double kTexels = 4.0;
    const double reach = kTexels / lights_->layout.size;
    const double metres = kTexels * static_cast<double>(lights_->layout.texels[light]);
    const glm::mat4& m = gpu.clip_from_world;
    const auto per_metre = static_cast<double>(glm::length(glm::vec3(m[0][2], m[1][2], m[2][2])));
    const double depth = static_cast<double>(clip.z) - metres * per_metre;
    for (const SharedCells& cells : casters_) {
      const double nearest = cells->nearest_depth(gpu.first_layer, at - reach, at + reach);
      if (nearest > 0.0 && !(nearest <= depth)) return true;
    }
    return false;
  }

 private:
  SharedLights lights_;
  std::vector<SharedCells> casters_;
};

}  // namespace

graph::Handle<VirtualShadows> add_shadow_bound_pass(graph::FrameGraph& graph,
                                                    const ShadowMapOutputs& shadows) {
  static constexpr std::array kCasters{CasterClass::VirtualOpaque, CasterClass::VirtualGlass};
  graph::Builder builder = graph.add_pass("shadow bound");
  builder.needs(shadows.lights);
  for (const CasterClass caster : kCasters) {
    builder.uses(shadows.maps[static_cast<std::size_t>(caster)]);
  }
  const auto out = builder.writes<VirtualShadows>("virtual shadow bound");
  builder.runs([shadows, out](const graph::Access& access) {
    std::vector<SharedCells> casters;
    for (const CasterClass caster : kCasters) {
      const ShadowMap* map = access.find(shadows.maps[static_cast<std::size_t>(caster)]);
      if (map != nullptr) casters.push_back(map->cells);
    }
    access.set(out, VirtualShadows(std::make_shared<const CellsBound>(access.get(shadows.lights),
                                                                      std::move(casters))));
  });
  return out;
}

}  // namespace amalgam::passes
