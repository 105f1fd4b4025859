#include "passes/raster/shadow_maps.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/gl_error.h"
#include "gl/pipeline_state.h"
#include "gl/shader_interface.h"
#include "passes/raster/draw_items.h"

namespace amalgam::passes {
namespace {

constexpr std::array<const char*, kCasterClasses> kClassNames = {"real opaque", "virtual opaque",
                                                                 "real glass", "virtual glass"};

CasterClass class_of(scene::Role role, scene::MaterialKind kind) {
  const bool real = role == scene::Role::Real;
  if (kind == scene::MaterialKind::Dielectric)
    return real ? CasterClass::RealGlass : CasterClass::VirtualGlass;
  return real ? CasterClass::RealOpaque : CasterClass::VirtualOpaque;
}

bool is_glass(CasterClass casters) {
  return casters == CasterClass::RealGlass || casters == CasterClass::VirtualGlass;
}

bool is_virtual(CasterClass casters) {
  return casters == CasterClass::VirtualOpaque || casters == CasterClass::VirtualGlass;
}

bool has_casters(const ShadowMapInputs& in, CasterClass casters) {
  const auto& instances = in.view.scene.instances;
  return std::any_of(instances.begin(), instances.end(), [&](const auto& anchored) {
    const gl::GpuInstanceInfo& info = in.raster.scene.instances()[anchored.instance];
    return class_of(info.role, info.kind) == casters;
  });
}

bool holds(const SharedLights& made_for, const ShadowMapInputs& in) {
  return made_for && is_layout_of(made_for->layout, in.view, in.options.size);
}

graph::Handle<SharedLights> add_lights(graph::FrameGraph& graph, const ShadowMapInputs& in) {
  if (holds(in.cache.lights, in)) {
    graph.note_left_out("upload lights", kNothingMoved);
    return graph.import("lights", in.cache.lights);
  }
  graph::Builder builder = graph.add_pass("upload lights");
  const auto out = builder.writes<SharedLights>("lights");
  builder.runs([in, out](const graph::Access& access) {
    in.raster.context.check_thread();
    ShadowLayout layout = make_shadow_layout(in.view, in.raster.scene, in.options.size);
    std::vector<gl::GpuLight> block = layout.gpu_lights;
    block.resize(gl::kMaxLights);  // a block must be bound in full
    gl::Buffer lights = gl::Buffer::of(std::span<const gl::GpuLight>(block));
    gl::Buffer layers = gl::Buffer::of(std::span<const gl::GpuShadowLayer>(layout.layers));
    in.cache.lights = std::make_shared<const DeviceLights>(
        DeviceLights{std::move(layout), std::move(lights), std::move(layers)});
    access.set(out, in.cache.lights);
  });
  return out;
}

// The array of layers, reused if it has the right shape.
const gl::Texture& ensure_layers(std::optional<gl::Texture>& image, CasterClass casters,
                                 const ShadowLayout& layout) {
  const int layers = static_cast<int>(layout.layers.size());
  // A texel of glass takes four times the memory, and its transmittance is smooth except at the
  // rim.
  const glm::ivec2 size(is_glass(casters) ? std::max(layout.size / 2, 1) : layout.size);
  if (!image || image->size() != size || image->layers() != layers) {
    image.reset();
    const bool glass = is_glass(casters);
    image.emplace(glass ? gl::TextureFormat::Rgba32f : gl::TextureFormat::Depth32f, size, layers);
    if (!glass) image->set_zero_outside();  // nothing occludes there
  }
  return *image;
}

void draw_layer(const RasterContext& raster, const DeviceView& device_view, CasterClass casters,
                const gl::Texture& image, int layer) {
  using State = gl::PipelineState;
  const bool glass = is_glass(casters);
  gl::Framebuffer::Attachments attachments{.layer = layer};
  if (glass) {
    attachments.colors = {&image};
  } else {
    attachments.depth = &image;
  }
  const gl::Framebuffer framebuffer(attachments);
  gl::apply(glass ? State{.blend = State::Blend::AddColorKeepNearest}
                  : State{.depth = State::Depth::NearestWrites, .push_depth_away = true});
  framebuffer.bind();
  if (glass) {
    framebuffer.clear_color(0, glm::vec4(0.0f));
  } else {
    framebuffer.clear_depth();
  }
  draw_items(raster, device_view,
             glass ? raster.shaders.accumulate_glass : raster.shaders.draw_caster,
             glass ? TextureUse::Color : TextureUse::Holes,
             [&](const DrawItem& item) { return class_of(item.role, item.kind) == casters; });
}

graph::Handle<ShadowMap> add_caster_class(graph::FrameGraph& graph, const ShadowMapInputs& in,
                                          CasterClass casters, graph::Handle<SharedLights> lights) {
  const auto index = static_cast<std::size_t>(casters);
  const std::string pass = std::string("shadow maps, ") + kClassNames[index];
  const std::string resource = std::string("shadow map of ") + kClassNames[index];
  ShadowCache::Entry& entry = in.cache.entries[index];
  if (!has_casters(in, casters)) {
    const std::string reason = std::string("no ") + kClassNames[index] + " object";
    graph.note_left_out(pass, reason);
    return graph.absent<ShadowMap>(resource, reason);
  }
  if (in.view.lights.empty()) {
    graph.note_left_out(pass, "no light");
    return graph.absent<ShadowMap>(resource, "no light");
  }
  if (entry.image && holds(entry.drawn_for, in)) {
    graph.note_left_out(pass, kNothingMoved);
    return graph.import(resource, ShadowMap{&*entry.image, entry.cells});
  }
  graph::Builder builder = graph.add_pass(pass);
  builder.needs(lights);
  builder.needs(in.device_view);
  const auto out = builder.writes<ShadowMap>(resource);
  builder.runs([in, casters, lights, out, &entry](const graph::Access& access) {
    const SharedLights& device_lights = access.get(lights);
    entry.drawn_for.reset();  // what fails half-way holds for no lights
    const gl::Texture& image = ensure_layers(entry.image, casters, device_lights->layout);
    device_lights->layers.bind_storage(gl::kShadowLayerBinding);
    for (int layer = 0; layer < image.layers(); ++layer) {
      device_lights->layers.bind_uniform_range(
          gl::kShadowLayerBinding, static_cast<std::size_t>(layer) * sizeof(gl::GpuShadowLayer),
          sizeof(gl::GpuShadowLayer));
      draw_layer(in.raster, access.get(in.device_view), casters, image, layer);
    }
    glFinish();  // or a later pass would be charged for this pass's time
    gl::throw_pending_gl_error("drawing shadow maps");
    if (is_virtual(casters)) {
      entry.cells =
          std::make_shared<const CasterCells>(CasterCells::of(image, device_lights->layout.size));
    }
    entry.drawn_for = device_lights;
    access.set(out, ShadowMap{&image, entry.cells});
  });
  return out;
}

}  // namespace

ShadowMapOutputs add_shadow_maps_pass(graph::FrameGraph& graph, const ShadowMapInputs& in) {
  ShadowMapOutputs out;
  out.lights = add_lights(graph, in);
  for (std::size_t i = 0; i < kCasterClasses; ++i) {
    out.maps[i] = add_caster_class(graph, in, static_cast<CasterClass>(i), out.lights);
  }
  return out;
}

}  // namespace amalgam::passes
