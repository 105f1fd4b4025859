#include "passes/composite.h"

#include <tbb/parallel_for.h>

#include <string>

#include "scene/tone_map.h"

namespace amalgam::passes {

core::ImageRgb8 composite(const core::Layers& layers, const core::ImageRgb8& camera_image) {
  AMALGAM_CHECK(
      layers.over.size() == camera_image.size() && layers.difference.size() == camera_image.size(),
      "layers are " + std::to_string(layers.over.width()) + "x" +
          std::to_string(layers.over.height()) + ", the camera image is " +
          std::to_string(camera_image.width()) + "x" + std::to_string(camera_image.height()));
  core::ImageRgb8 out = camera_image;
  tbb::parallel_for(0, out.height(), [&](int y) {
    for (int x = 0; x < out.width(); ++x) {
      const glm::vec4& over = layers.over.at(x, y);
      const glm::vec3& difference = layers.difference.at(x, y);
      if (over == glm::vec4(0.0f) && difference == glm::vec3(0.0f)) continue;
      const glm::vec3 camera = scene::srgb_decode(camera_image.at(x, y));
      out.at(x, y) = scene::srgb_encode(glm::vec3(over) + (1.0f - over.w) * camera + difference);
    }
  });
  return out;
}

graph::Handle<Composite> add_composite_pass(graph::FrameGraph& graph, const CompositeInputs& in) {
  graph::Builder builder = graph.add_pass("composite");
  if (in.even_if_unchanged) {
    builder.uses(in.layers);
  } else {
    builder.needs(in.layers);
  }
  builder.needs(in.camera_image);
  const auto out = builder.writes<Composite>("composite");
  builder.runs([in, out](const graph::Access& access) {
    const core::ImageRgb8& camera_image = access.get(in.camera_image).pixels;
    const Layers* layers = access.find(in.layers);
    access.set(out, Composite{layers != nullptr ? composite(*layers, camera_image) : camera_image});
  });
  return out;
}

}  // namespace amalgam::passes
