#include "truth/truth_rendering.h"

#include "scene/gltf/environment_loader.h"
#include "scene/gltf/loader.h"

namespace amalgam::truth {

std::vector<Method> methods() {
  const frame::RendererSettings default_settings;
  frame::RendererSettings thesis, many_lights;
  thesis.env_lights = scene::parse_env_light_options("sectors");
  many_lights.env_lights = scene::parse_env_light_options("median-cut:64");
  std::vector<Method> list{{"default", default_settings}, {"64 lights", many_lights}};
  if (thesis.env_lights != default_settings.env_lights) {
    list.push_back({"eq. 4.5, 8 lights", thesis});
  }
  return list;
}

TruthRenderer::TruthRenderer(const TruthCase& truth_case, const Method& method)
    : truth_case_(truth_case),
      renderer_(scene::load_scene(truth_case.scene_path, {.load_environment = false}),
                method.settings) {}

void TruthRenderer::light_by(const Environment& environment) {
  std::vector<std::string> notes;
  renderer_.set_environment(scene::load_environment(environment.path, notes));
}

frame::FrameOutput TruthRenderer::render(const common::ImageRgb8& camera,
                                         frame::FrameBuffers* buffers) {
  frame::ViewOptions options;
  options.camera = truth_case_.camera;
  options.keep_pixels = true;
  // A view of its own: exposure is smooth in time.
  frame::ViewState view(options);
  return renderer_.render(view, {camera, {truth_case_.pose}}, buffers);
}

common::ImageRgb8 TruthRenderer::composite(const common::ImageRgb8& camera) {
  return render(camera, nullptr).pixels;
}

common::Image32f TruthRenderer::virtual_mask(const common::ImageRgb8& camera) {
  frame::FrameBuffers buffers;
  render(camera, &buffers);
  return std::get<common::Image32f>(buffers.at("virtual_mask"));
}

}  // namespace amalgam::truth
