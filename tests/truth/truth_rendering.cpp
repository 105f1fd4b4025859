#include "truth/truth_rendering.h"

#include "scene/gltf/environment_loader.h"
#include "scene/gltf/loader.h"

namespace amalgam::truth {

Method by_default() {
  return {"default", {}};
}

Method with_64_lights() {
  Method method{"64 lights", {}};
  method.settings.env_lights = scene::parse_env_light_options("median-cut:64");
  return method;
}

Method of_the_thesis() {
  Method method{"eq. 4.5, 8 lights", {}};
  method.settings.env_lights = scene::parse_env_light_options("sectors");
  method.settings.real_surfaces = scene::RealSurfaces::Difference;
  method.settings.exposure_card = passes::ExposureCard::Grey;
  method.settings.tone_curve = scene::ToneCurve::Reinhard;
  return method;
}

std::vector<Method> parts_off() {
  std::vector<Method> list;
  const auto without = [&](const char* name, auto change) {
    list.push_back({name, with_64_lights().settings});
    change(list.back().settings);
  };
  without("8 lights", [](auto& s) { s.env_lights = of_the_thesis().settings.env_lights; });
  without("difference", [](auto& s) { s.real_surfaces = scene::RealSurfaces::Difference; });
  without("grey card", [](auto& s) { s.exposure_card = passes::ExposureCard::Grey; });
  without("always reinhard", [](auto& s) { s.tone_curve = scene::ToneCurve::Reinhard; });
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
