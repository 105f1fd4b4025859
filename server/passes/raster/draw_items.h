// Draws the instances of a view that a pass selects.
#pragma once

#include "gl/shader_interface.h"
#include "gl/shader_library.h"
#include "passes/raster/raster_context.h"
#include "passes/raster/upload_view.h"

namespace amalgam::passes {

// What a pass needs textures and vertex colors for: the whole material, or only its alpha cut-outs.
enum class TextureUse : std::uint8_t { Color, Holes };

// The caller sets the framebuffer, the pipeline state and the program's own uniforms. wanted(const
// DrawItem&) -> bool.
template <typename Wanted>
void draw_items(const RasterContext& raster, const DeviceView& device_view,
                const gl::SurfaceProgram& programs, TextureUse use, const Wanted& wanted) {
  raster.scene.bind_tables();
  device_view.frame.bind_uniform(gl::kFrameBinding);
  for (std::size_t i = 0; i < device_view.items.size(); ++i) {
    const DrawItem& item = device_view.items[i];
    if (!wanted(item)) continue;
    const bool detailed = use == TextureUse::Color ? item.detailed : item.cut_out;
    (detailed ? *programs.detailed : programs.plain).use();
    device_view.surfaces.bind_uniform_range(gl::kSurfaceBinding, i * sizeof(gl::GpuSurface),
                                            sizeof(gl::GpuSurface));
    raster.scene.draw(item.mesh, item.material);
  }
}

}  // namespace amalgam::passes
