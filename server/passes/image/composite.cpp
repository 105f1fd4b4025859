#include "passes/image/composite.h"

#include <tbb/parallel_for.h>

#include <string>
#include <utility>
#include <vector>

#include "scene/light/real_surfaces.h"

namespace amalgam::passes {

namespace {

glm::vec3 compose(const core::LayerPixel& pixel, const glm::vec3& camera, scene::ToneCurve curve) {
  const glm::vec3 lit = scene::scale_light(camera, pixel.light_ratio(), curve);
  return glm::vec3(pixel.over) + (1.0f - pixel.over.w) * lit + pixel.difference;
}

}  // namespace

common::ImageRgb8 composite(const core::Layers& layers, common::ImageRgb8 image,
                            scene::ToneCurve curve) {
  AMALGAM_CHECK(layers.size() == image.size(),
                "layers are " + std::to_string(layers.size().x) + "x" +
                    std::to_string(layers.size().y) + ", the camera image is " +
                    std::to_string(image.width()) + "x" + std::to_string(image.height()));
  const std::vector<std::size_t> tiles = layers.present();
  tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t i) {
    const core::LayerTile& tile = *layers.find(tiles[i]);
    const glm::ivec2 first = layers.grid().first_pixel(tiles[i]);
    const glm::ivec2 end = layers.grid().end_pixel(tiles[i]);
    for (int y = first.y; y < end.y; ++y) {
      for (int x = first.x; x < end.x; ++x) {
        const core::LayerPixel& layer = tile.at(x, y);
        if (layer.is_zero()) continue;
        common::Rgb8& pixel = image.at(x, y);
        pixel = scene::srgb_encode(compose(layer, scene::srgb_decode(pixel), curve));
      }
    }
  });
  return image;
}

graph::Handle<Composite> add_composite_pass(graph::FrameGraph& graph, const CompositeInputs& in) {
  graph::Builder builder = graph.add_pass("composite");
  if (in.even_if_unchanged) {
    builder.uses(in.layers);
  } else {
    builder.needs(in.layers);
  }
  builder.needs(in.camera_image);
  builder.needs(in.tone_map);
  const auto out = builder.writes<Composite>("composite");
  builder.runs([in, out](const graph::Access& access) {
    common::ImageRgb8 image = access.take(in.camera_image).pixels;
    const Layers* layers = access.find(in.layers);
    std::vector<std::uint8_t> changed(core::TileGrid(image.size()).count());
    if (layers != nullptr) {
      for (const std::size_t tile : layers->present()) changed[tile] = 1;
      image = composite(*layers, std::move(image), access.get(in.tone_map).curve);
    }
    access.set(out, Composite{std::move(image), std::move(changed)});
  });
  return out;
}

}  // namespace amalgam::passes
