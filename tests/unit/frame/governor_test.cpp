#include "frame/governor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace amalgam::frame {
namespace {

constexpr double kBudget = 1000.0 / 30.0;

// Much to go down from, whatever the defaults are.
RendererSettings fine_settings() {
  RendererSettings settings;
  settings.trace.max_depth = 10;
  settings.trace.importance_cutoff = 0.004f;
  settings.jpeg_quality = 90;
  settings.coarse_allowed = true;
  return settings;
}

// Frames that take what the scene's real costs say, which the governor does not know.
class Simulation {
 public:
  explicit Simulation(const RendererSettings& settings = fine_settings(), int client_quality = 0)
      : ladder_(make_quality_ladder(settings)),
        governor_(kBudget, ladder_,
                  client_quality != 0 ? std::vector<JpegLevel>{{client_quality}}
                                      : make_jpeg_ladder(settings.jpeg_quality)) {}

  FrameCost full{.trace = 10.0, .raster = 5.0, .encode = 4.0, .other = 2.0, .specular = 0.12};
  double noise = 0.0;  // relative, evenly spread
  // How wrong the first guesses are: 1 is right, 2 saves half of what was thought.
  double surprise = 1.0;

  // Milliseconds of the frame.
  double render() {
    const QualityLevel& level = governor_.quality();
    FrameCost cost = full;
    const double all = wobble();  // as when other programs take the cores
    cost.trace *= std::pow(level.trace_cost, 1.0 / surprise) * all;
    cost.raster *= std::pow(level.raster_cost, 1.0 / surprise) * all;
    cost.encode *= (0.5 + 0.5 * governor_.jpeg_quality() / 90.0) * all;
    cost.other *= all;
    const int before = this->level();
    governor_.frame_done(cost);
    if (this->level() != before) ++changes;
    return cost.total();
  }
  double render(int frames) {
    double last = 0.0;
    for (int i = 0; i < frames; ++i) last = render();
    return last;
  }

  int level() const { return governor_.report().level; }
  FrameQuality report() const { return governor_.report(); }
  const std::vector<QualityLevel>& ladder() const { return ladder_; }
  int changes = 0;

 private:
  double wobble() { return std::uniform_real_distribution(1.0 - noise, 1.0 + noise)(random_); }

  std::vector<QualityLevel> ladder_;
  Governor governor_;
  std::mt19937 random_{7};
};

TEST(Governor, CheapFramesKeepFullQuality) {
  Simulation simulation;
  simulation.render(100);
  EXPECT_EQ(simulation.changes, 0);
  EXPECT_EQ(simulation.report().bound, FrameQuality::Bound::Nothing);
}

TEST(Governor, ConvergesBelowTheBudget) {
  for (const double surprise : {0.5, 0.7, 1.0, 1.6}) {
    for (double trace = 36.0; trace < 90.0; trace += 3.0) {
      Simulation simulation;
      simulation.surprise = surprise;
      simulation.full.trace = trace;
      EXPECT_LE(simulation.render(60), kBudget) << surprise << " " << trace;
      const int settled = simulation.changes;
      simulation.render(600);
      EXPECT_EQ(simulation.changes, settled) << surprise << " " << trace;
      EXPECT_EQ(simulation.report().bound, FrameQuality::Bound::Trace) << surprise << " " << trace;
    }
  }
}

// Calm frames count in a row: one over the budget begins the count anew.
TEST(Governor, AFrameOverItsBudgetEndsTheCalm) {
  Simulation simulation;
  simulation.full.trace = 60.0;
  simulation.render(60);
  simulation.full.trace = 8.0;
  simulation.render(Governor::kCalmFrames - 1);
  simulation.full.trace = 300.0;
  simulation.render();
  simulation.full.trace = 8.0;
  const int low = simulation.level();
  for (int i = 1; i < Governor::kCalmFrames; ++i) {
    simulation.render();
    EXPECT_EQ(simulation.level(), low) << i;
  }
  simulation.render(2);
  EXPECT_LT(simulation.level(), low);
}

// Not lower than need be: one level up would be at the budget or over kCalm of it.
TEST(Governor, SpendsWhatItHas) {
  Simulation simulation;
  simulation.full.trace = 60.0;
  const double milliseconds = simulation.render(200);
  const auto& ladder = simulation.ladder();
  const auto level = static_cast<std::size_t>(
      std::find_if(ladder.begin(), ladder.end(),
                   [&](const QualityLevel& l) {
                     return l.importance_cutoff == simulation.report().importance_cutoff &&
                            l.max_depth == simulation.report().max_depth &&
                            l.render_scale == simulation.report().render_scale;
                   }) -
      ladder.begin());
  ASSERT_GT(level, 0u);
  const double better = milliseconds +
                        60.0 * (ladder[level - 1].trace_cost - ladder[level].trace_cost) +
                        5.0 * (ladder[level - 1].raster_cost - ladder[level].raster_cost);
  EXPECT_GT(better, 0.99 * Governor::kCalm * kBudget);
}

TEST(Governor, DoesNotOscillateUnderNoise) {
  for (double trace = 20.0; trace < 130.0; trace += 2.5) {
    Simulation simulation;
    simulation.noise = 0.1;
    simulation.full.trace = trace;
    simulation.render(60);
    simulation.changes = 0;
    simulation.render(900);  // half a minute
    EXPECT_LE(simulation.changes, 2) << trace;
  }
}

TEST(Governor, FollowsASuddenDoublingWithinTwoFrames) {
  Simulation simulation;
  simulation.full.trace = 20.0;
  simulation.render(50);
  simulation.full.trace = 40.0;
  simulation.full.raster = 10.0;
  EXPECT_GT(simulation.render(), kBudget);
  simulation.render();
  EXPECT_LE(simulation.render(), kBudget);
}

// A camera that comes nearer just after a change makes nobody believe that the change was in vain.
TEST(Governor, WhatIsLearnedIsOfTheSameThings) {
  for (double trace = 36.0; trace < 80.0; trace += 2.0) {
    Simulation simulation;
    simulation.full.trace = trace;
    simulation.render();
    for (int i = 0; i < 5; ++i) {
      simulation.full.trace *= 1.06;
      simulation.full.specular *= 1.06;
      simulation.render();
    }
    simulation.render(5);
    const int settled = simulation.changes;
    simulation.render(200);
    EXPECT_EQ(simulation.changes, settled) << trace;
  }
}

TEST(Governor, ReturnsToFullQuality) {
  Simulation simulation;
  simulation.full.trace = 200.0;
  simulation.render(100);
  EXPECT_GT(simulation.level(), 3);
  simulation.full.trace = 10.0;
  simulation.render(100);
  EXPECT_EQ(simulation.level(), 0);
}

TEST(Governor, NeverBelowTheLowest) {
  Simulation simulation;
  simulation.full.trace = 1e5;
  simulation.render(50);
  EXPECT_LE(simulation.level(), simulation.report().lowest_level);
  EXPECT_EQ(simulation.report().max_depth, 4);
  EXPECT_EQ(simulation.report().jpeg_quality, 90) << "which would not help";
  EXPECT_EQ(simulation.report().bound, FrameQuality::Bound::Lowest);
  EXPECT_EQ(simulation.report().render_scale, 0.5f);
  simulation.full.trace = 0.0;  // nothing specular in view any more
  simulation.full.specular = 0.0;
  simulation.render(100);
  EXPECT_EQ(simulation.level(), 0);
}

// One quick frame among slow ones is no reason to go up.
TEST(Governor, GoesUpOnlyAfterSeveralCalmFrames) {
  Simulation simulation;
  simulation.full.trace = 100.0;
  simulation.render(50);
  const int settled = simulation.level();
  for (int i = 0; i < 20; ++i) {
    simulation.full.trace = 10.0;
    simulation.render(3);
    EXPECT_EQ(simulation.level(), settled);
    simulation.full.trace = 100.0;
    simulation.render();
  }
  EXPECT_EQ(simulation.level(), settled);
}

// What is made once, as shadow maps in the first frame, is no reason to lower anything.
TEST(Governor, OneSlowPassThatQualityDoesNotChangeIsForgiven) {
  Simulation simulation;
  simulation.full.other = 500.0;
  simulation.render();
  simulation.full.other = 2.0;
  simulation.render(30);
  simulation.full.other = 300.0;
  simulation.render();
  simulation.full.other = 2.0;
  simulation.render();
  EXPECT_EQ(simulation.changes, 0);
  simulation.full.other = 300.0;
  simulation.render(2);
  EXPECT_GT(simulation.changes, 0);
}

TEST(Governor, JpegIsCoarserOnlyIfEncodingDominates) {
  for (double trace = 20.0; trace < 300.0; trace += 5.0) {
    Simulation tracing;
    tracing.full.encode = 8.0;
    tracing.full.trace = trace;
    tracing.render(100);
    EXPECT_EQ(tracing.report().jpeg_quality, 90) << trace;
  }
  Simulation encoding;
  encoding.full = {.trace = 1.0, .raster = 1.0, .encode = 36.0, .other = 1.0, .specular = 0.1};
  encoding.render(100);
  EXPECT_LT(encoding.report().jpeg_quality, 90);
  EXPECT_EQ(encoding.report().bound, FrameQuality::Bound::Encode);
}

TEST(Governor, AClientsOwnJpegQualityStays) {
  Simulation simulation(fine_settings(), 97);
  simulation.full.encode = 100.0;
  simulation.render(100);
  EXPECT_EQ(simulation.report().jpeg_quality, 97);
}

TEST(Governor, SameCostsSameChoices) {
  Simulation a, b;
  a.noise = b.noise = 0.3;
  a.full.trace = b.full.trace = 70.0;
  for (int i = 0; i < 200; ++i) {
    a.render();
    b.render();
    ASSERT_EQ(a.level(), b.level());
  }
}

// Two levels, the second at half the cost of tracing; a budget of 10 ms.
Governor two_levels() {
  std::vector<QualityLevel> ladder(2);
  ladder[1].trace_cost = 0.5;
  return Governor(10.0, ladder, {{90}});
}

// The object that is traced comes nearer just as the quality changes, and goes back: a level that
// takes 11 ms is not tried again although the frame's time has hardly changed.
TEST(Governor, CostsAreLearnedForEachSpecularPixel) {
  Governor governor = two_levels();
  governor.frame_done({.trace = 11.0, .specular = 0.1});
  ASSERT_EQ(governor.report().level, 1);
  for (int i = 0; i < 10; ++i) governor.frame_done({.trace = 8.8, .specular = 0.16});
  for (int i = 0; i < 20; ++i) governor.frame_done({.trace = 5.5, .specular = 0.1});
  EXPECT_EQ(governor.report().level, 1);
}

// The cost jumps from 6 to 12 ms. What the better level took is the latter, not the mean of many
// frames: at 6 ms in the second level it would take 12 again.
TEST(Governor, AJumpIsFollowedAtOnce) {
  Governor governor = two_levels();
  for (int i = 0; i < 20; ++i) governor.frame_done({.trace = 6.0, .specular = 0.1});
  ASSERT_EQ(governor.report().level, 0);
  governor.frame_done({.trace = 12.0, .specular = 0.1});
  ASSERT_EQ(governor.report().level, 1);
  for (int i = 0; i < 20; ++i) governor.frame_done({.trace = 6.0, .specular = 0.1});
  EXPECT_EQ(governor.report().level, 1);
}

}  // namespace
}  // namespace amalgam::frame
