#include "bench/stage_sums.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace amalgam::bench {
namespace {

const core::StageTimes kStages{{"decode", 1},     {"shadow maps", 2}, {"shadow maps (glass)", 4},
                               {"mask", 8},       {"diffuse", 16},    {"trace", 32},
                               {"composite", 64}, {"encode", 128},    {"place instances", 256},
                               {"total", 512}};

TEST(StageSums, RasterIsAllButTracerCodecsAndWhatMoved) {
  EXPECT_DOUBLE_EQ(raster_milliseconds(kStages), 8 + 16 + 64);
}

TEST(StageSums, TheWholeIsNoStage) {
  EXPECT_DOUBLE_EQ(sum_of_stages(kStages), 511);
  EXPECT_DOUBLE_EQ(stage_milliseconds(kStages, "trace"), 32);
}

TEST(StageSums, AStageThatDidNotRunHasNoTime) {
  EXPECT_THROW(stage_milliseconds(kStages, "warp"), std::runtime_error);
}

}  // namespace
}  // namespace amalgam::bench
