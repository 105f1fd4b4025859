#include "passes/raster/raster_context.h"

namespace amalgam::passes {

const gl::Texture& ensure_target(std::optional<gl::Texture>& target, gl::TextureFormat format,
                                 glm::ivec2 size) {
  if (!target || target->size() != size) {
    target.reset();  // first, so that both are never held at a time
    target.emplace(format, size);
  }
  return *target;
}

glm::ivec2 sample_size(const RenderView& view) {
  return glm::ivec2(view.ideal.width, view.ideal.height) * view.samples_per_side;
}

}  // namespace amalgam::passes
