// Draws the instances of a view that a pass cares for, with one program.
#pragma once

#include "gl/shader_interface.h"
#include "gl/shader_program.h"
#include "passes/raster_context.h"
#include "passes/upload_view.h"

namespace amalgam::passes {

// The framebuffer and the pipeline state are set by the caller. wanted(const DrawItem&) -> bool.
template <typename Wanted>
void draw_items(const RasterContext& raster, const DeviceView& device_view,
                const gl::ShaderProgram& program, const Wanted& wanted) {
  program.use();
  raster.scene.bind_tables();
  device_view.frame.bind_uniform(gl::kFrameBinding);
  device_view.instances.bind_storage(gl::kInstancesBinding);
  for (std::size_t i = 0; i < device_view.items.size(); ++i) {
    const DrawItem& item = device_view.items[i];
    if (!wanted(item)) continue;
    program.set(gl::kInstanceIndexLocation, static_cast<GLuint>(i));
    raster.scene.draw(item.mesh, item.material);
  }
}

// One triangle over all of the framebuffer, for passes from image to image.
inline void cover_screen(const RasterContext& raster, const gl::ShaderProgram& program) {
  program.use();
  raster.scene.draw_screen();
}

}  // namespace amalgam::passes
