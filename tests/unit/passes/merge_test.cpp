#include "passes/image/merge.h"

#include <gtest/gtest.h>

namespace amalgam::passes {
namespace {

Layers constant_layers(float value) {
  Layers layers({4, 3});
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) layers.set(x, y, {glm::vec4(value), glm::vec3(-value)});
  }
  return layers;
}

trace::TraceResult traced_layers(float value) {
  trace::TraceResult result;
  result.layers = constant_layers(value);
  return result;
}

TEST(Merge, Adds) {
  graph::FrameGraph graph;
  const auto merged = add_merge_pass(graph, {graph.import("raster", constant_layers(0.25f)),
                                             graph.import("trace", traced_layers(0.5f))});
  const Layers* layers = graph.realise(merged);
  ASSERT_NE(layers, nullptr);
  EXPECT_EQ(layers->at(3, 2).over, glm::vec4(0.75f));
  EXPECT_EQ(layers->at(0, 0).difference, glm::vec3(-0.75f));
}

TEST(Merge, OneIsEnough) {
  graph::FrameGraph graph;
  const auto merged =
      add_merge_pass(graph, {graph.absent<Layers>("raster", "no diffuse object in view"),
                             graph.import("trace", traced_layers(0.5f))});
  ASSERT_NE(graph.realise(merged), nullptr);
  EXPECT_EQ(graph.peek(merged)->at(1, 1).over, glm::vec4(0.5f));
}

TEST(Merge, ZeroEverywhereIsNothing) {
  graph::FrameGraph graph;
  const auto merged = add_merge_pass(graph, {graph.import("raster", constant_layers(0.0f)),
                                             graph.import("trace", traced_layers(0.0f))});
  EXPECT_EQ(graph.realise(merged), nullptr);
  EXPECT_EQ(graph.reason_absent(merged), "nothing virtual has an effect on this frame");
}

}  // namespace
}  // namespace amalgam::passes
