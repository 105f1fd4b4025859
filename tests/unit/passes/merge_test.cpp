#include "passes/merge.h"

#include <gtest/gtest.h>

namespace amalgam::passes {
namespace {

Layers constant_layers(float value) {
  return {core::ImageRgba32f(4, 3, glm::vec4(value)), core::ImageRgb32f(4, 3, glm::vec3(-value))};
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
  EXPECT_EQ(layers->over.at(3, 2), glm::vec4(0.75f));
  EXPECT_EQ(layers->difference.at(0, 0), glm::vec3(-0.75f));
}

TEST(Merge, OneIsEnough) {
  graph::FrameGraph graph;
  const auto merged =
      add_merge_pass(graph, {graph.absent<Layers>("raster", "no diffuse object in view"),
                             graph.import("trace", traced_layers(0.5f))});
  ASSERT_NE(graph.realise(merged), nullptr);
  EXPECT_EQ(graph.peek(merged)->over.at(1, 1), glm::vec4(0.5f));
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
