#include "unit/trace/furnace.h"

#include <gtest/gtest.h>

#include <utility>

#include "trace/media_at.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {

void expect_furnace(const scene::Scene& scene) {
  const scene::Environment furnace = constant_environment(1.0f);
  EmbreeScene embree(scene);
  embree.place(anchor_all(scene));
  int seen = 0;
  for (const glm::dvec3& eye : {glm::dvec3(0.1, 0.2, 3.0), glm::dvec3(2.0, 1.5, -1.0),
                                glm::dvec3(-0.3, -2.5, 0.5), glm::dvec3(0.0, 0.05, 0.1)}) {
    const double index = refractive_index(media_at(embree, glm::vec3(eye)), scene.materials);
    const auto expected = static_cast<float>(index * index);
    for (const auto& [depth, cutoff] : {std::pair{0, 0.0f}, {3, 0.0f}, {10, 0.004f}}) {
      const TraceResult result =
          trace_shot(scene, {.eye = eye,
                             .settings = {.max_depth = depth, .importance_cutoff = cutoff},
                             .environment = &furnace,
                             .width = 40,
                             .height = 40,
                             .focal_length = 40});
      ASSERT_EQ(result.nonfinite, 0u);
      for (std::size_t i = 0; i < result.images->mixed.pixels().size(); ++i) {
        if (result.images->met_virtual.pixels()[i] == 0) continue;
        ++seen;
        const glm::vec3& pixel = result.images->mixed.pixels()[i];
        ASSERT_NEAR(pixel.x, expected, expected * kFurnaceBound)
            << "pixel " << i << " depth " << depth;
        ASSERT_EQ(pixel, glm::vec3(pixel.x)) << "pixel " << i << " depth " << depth;
      }
    }
  }
  EXPECT_GT(seen, 500) << "the objects are hardly in view";
}

}  // namespace amalgam::trace
