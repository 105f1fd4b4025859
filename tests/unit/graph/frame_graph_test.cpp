#include "graph/frame_graph.h"

#include <gtest/gtest.h>

namespace amalgam::graph {
namespace {

// Adds a pass that writes value once all its needs are there, and counts its runs.
Handle<int> add_constant(FrameGraph& graph, const std::string& name, int value, int& runs,
                         const std::vector<Handle<int>>& needs = {}) {
  Builder builder = graph.add_pass(name);
  for (const auto& need : needs) builder.needs(need);
  const auto out = builder.writes<int>(name + " result");
  builder.runs([out, value, &runs](const Access& access) {
    ++runs;
    access.set(out, value);
  });
  return out;
}

TEST(FrameGraph, RunsWhatTheOutputNeedsOnceAndNothingElse) {
  FrameGraph graph;
  int a_runs = 0, b_runs = 0, c_runs = 0, unread_runs = 0;
  const auto a = add_constant(graph, "a", 1, a_runs);
  const auto b = add_constant(graph, "b", 2, b_runs, {a});
  const auto c = add_constant(graph, "c", 3, c_runs, {a, b});
  add_constant(graph, "unread", 4, unread_runs, {a});
  ASSERT_NE(graph.realise(c), nullptr);
  EXPECT_EQ(*graph.realise(c), 3);
  EXPECT_EQ(a_runs, 1);
  EXPECT_EQ(b_runs, 1);
  EXPECT_EQ(c_runs, 1);
  EXPECT_EQ(unread_runs, 0);
  const auto reports = graph.reports();
  EXPECT_TRUE(reports[2].ran);
  EXPECT_FALSE(reports[3].ran);
  EXPECT_EQ(reports[3].reason, "nothing reads its result");
}

TEST(FrameGraph, AbsenceTravelsWithItsReason) {
  FrameGraph graph;
  int runs = 0;
  const auto missing = graph.absent<int>("glass", "no glass in the scene");
  const auto refraction = add_constant(graph, "refract", 1, runs, {missing});
  const auto image = add_constant(graph, "image", 2, runs, {refraction});
  EXPECT_EQ(graph.realise(image), nullptr);
  EXPECT_EQ(runs, 0);
  EXPECT_EQ(graph.reason_absent(image), "no glass in the scene");
  for (const PassReport& report : graph.reports())
    EXPECT_EQ(report.reason, "no glass in the scene");
}

TEST(FrameGraph, OptionalInputsMayBeAbsent) {
  FrameGraph graph;
  const auto missing = graph.absent<int>("x", "not there");
  const auto given = graph.import("y", 5);
  Builder builder = graph.add_pass("sum");
  builder.uses(missing);
  builder.uses(given);
  const auto sum = builder.writes<int>("sum");
  builder.runs([=](const Access& access) {
    EXPECT_EQ(access.find(missing), nullptr);
    access.set(sum, *access.find(given));
  });
  ASSERT_NE(graph.realise(sum), nullptr);
  EXPECT_EQ(*graph.peek(sum), 5);
}

// The order of needs() is the order of asking: what comes after an absent input is never made.
TEST(FrameGraph, DearInputsAfterAnAbsentOneAreNotMade) {
  FrameGraph graph;
  int decodes = 0, runs = 0;
  const auto image = add_constant(graph, "decode", 1, decodes);
  Builder builder = graph.add_pass("merge");
  const auto layers = builder.writes<int>("layers");
  builder.runs(
      [layers](const Access& access) { access.leave_empty(layers, "nothing virtual shows"); });
  const auto composite = add_constant(graph, "composite", 2, runs, {layers, image});
  EXPECT_EQ(graph.realise(composite), nullptr);
  EXPECT_EQ(decodes, 0);
  EXPECT_EQ(runs, 0);
  const auto reports = graph.reports();
  EXPECT_EQ(reports[0].reason, "nothing virtual shows") << "decode: for want of its reader";
  EXPECT_TRUE(reports[1].ran);
  EXPECT_EQ(reports[2].reason, "nothing virtual shows");
}

TEST(FrameGraph, OneAlternativeIsEnoughAndNoneIsNot) {
  FrameGraph graph;
  const auto no_raster = graph.absent<int>("raster", "nothing to draw");
  const auto no_trace = graph.absent<int>("trace", "nothing to trace");
  const auto some = graph.import("some", 3);
  const auto merge = [&](Handle<int> a, Handle<int> b) {
    Builder builder = graph.add_pass("merge");
    builder.needs_any(a);
    builder.needs_any(b);
    const auto out = builder.writes<int>("merged");
    builder.runs(
        [=](const Access& access) { access.set(out, access.find(b) ? *access.find(b) : 0); });
    return out;
  };
  const auto merged = merge(no_raster, some), none = merge(no_raster, no_trace);
  EXPECT_NE(graph.realise(merged), nullptr);
  EXPECT_EQ(graph.realise(none), nullptr);
  EXPECT_EQ(graph.reason_absent(none), "nothing to draw");
}

// One is enough, but a pass is given all that there are.
TEST(FrameGraph, AllAlternativesAreMade) {
  FrameGraph graph;
  int runs = 0;
  const auto a = add_constant(graph, "a", 1, runs), b = add_constant(graph, "b", 2, runs);
  Builder builder = graph.add_pass("merge");
  builder.needs_any(a);
  builder.needs_any(b);
  const auto out = builder.writes<int>("merged");
  builder.runs([=](const Access& access) {
    const int *first = access.find(a), *second = access.find(b);
    access.set(out, (first != nullptr ? *first : 0) + (second != nullptr ? *second : 0));
  });
  ASSERT_NE(graph.realise(out), nullptr);
  EXPECT_EQ(*graph.realise(out), 3);
  EXPECT_EQ(runs, 2);
}

TEST(FrameGraph, AnAbsentResourceSaysWhy) {
  FrameGraph graph;
  const auto missing = graph.absent<int>("shadow bound", "every sample is traced");
  EXPECT_EQ(graph.realise(missing), nullptr);
  EXPECT_EQ(graph.peek(missing), nullptr);
  EXPECT_EQ(graph.reason_absent(missing), "every sample is traced");
}

TEST(FrameGraph, NotesStandInThePassList) {
  FrameGraph graph;
  graph.note_left_out("shadow maps", "nothing moved");
  ASSERT_EQ(graph.reports().size(), 1u);
  EXPECT_EQ(graph.reports()[0].reason, "nothing moved");
  EXPECT_NE(graph.to_graphviz().find("shadow maps"), std::string::npos);
}

// The last reader may have the value itself; whoever reads before others are done gets a copy.
TEST(FrameGraph, TheLastReaderTakesWhatOthersCopy) {
  FrameGraph graph;
  const std::vector<int> numbers{1, 2, 3};
  const auto source = graph.import("numbers", numbers);
  const auto add_taker = [&](const std::string& name, const std::vector<Handle<int>>& needs) {
    Builder builder = graph.add_pass(name);
    for (const auto& need : needs) builder.needs(need);
    builder.needs(source);
    const auto out = builder.writes<int>(name + " result");
    builder.runs([source, out](const Access& access) {
      access.set(out, static_cast<int>(access.take(source).size()));
    });
    return out;
  };
  const auto first = add_taker("first", {});
  const auto last = add_taker("last", {first});
  ASSERT_NE(graph.realise(first), nullptr);
  EXPECT_EQ(*graph.peek(source), numbers) << "somebody may still read it";
  ASSERT_NE(graph.realise(last), nullptr);
  EXPECT_EQ(*graph.peek(first), 3);
  EXPECT_EQ(*graph.peek(last), 3);
  EXPECT_TRUE(graph.peek(source)->empty()) << "moved, not copied";
}

using FrameGraphDeathTest = testing::Test;

// A forgotten connection must not pass for a feature that the frame does not have.
TEST(FrameGraphDeathTest, AnUnsetHandleAbortsAndNamesThePass) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  FrameGraph graph;
  const Handle<int> unset;
  Builder builder = graph.add_pass("careless");
  const std::string message = "pass 'careless' was given an unset handle";
  EXPECT_DEATH(builder.needs(unset), message);
  EXPECT_DEATH(builder.uses(unset), message);
  EXPECT_DEATH(builder.needs_any(unset), message);
  const auto out = builder.writes<int>("out");
  builder.runs(
      [=](const Access& access) { access.set(out, access.find(unset) != nullptr ? 1 : 0); });
  EXPECT_DEATH(graph.realise(out), message);
}

TEST(FrameGraphDeathTest, AskingTheGraphForAnUnsetHandleAborts) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  FrameGraph graph;
  const Handle<int> unset;
  const std::string message = "the graph was given an unset handle";
  EXPECT_DEATH(graph.realise(unset), message);
  EXPECT_DEATH(graph.peek(unset), message);
  EXPECT_DEATH(graph.reason_absent(unset), message);
}

TEST(FrameGraphDeathTest, TouchingWhatWasNotDeclaredAborts) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  FrameGraph graph;
  const auto secret = graph.import("secret", 1);
  Builder builder = graph.add_pass("nosy");
  const auto out = builder.writes<int>("out");
  builder.runs([=](const Access& access) { access.set(out, access.get(secret)); });
  EXPECT_DEATH(graph.realise(out), "without declaring it");
}

TEST(FrameGraphDeathTest, PromisedButNotWrittenAborts) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  FrameGraph graph;
  Builder builder = graph.add_pass("lazy");
  const auto out = builder.writes<int>("out");
  builder.runs([](const Access&) {});
  EXPECT_DEATH(graph.realise(out), "did not write");
}

}  // namespace
}  // namespace amalgam::graph
