#include "passes/image/exposure.h"

#include <gtest/gtest.h>

namespace amalgam::passes {
namespace {

using scene::ToneCurve;

MeterReading grey(float exposure) {
  return {exposure, std::nullopt};
}

TEST(ExposureMemory, TakesTheFirstReadingAndApproachesLaterOnes) {
  ExposureMemory memory;
  EXPECT_EQ(memory.update({}), glm::vec3(1.0f));
  EXPECT_EQ(memory.update(grey(4.0f)), glm::vec3(4.0f));
  const glm::vec3 next = memory.update(grey(8.0f));
  EXPECT_GT(next.x, 4.0f);
  EXPECT_LT(next.x, 5.0f);
  EXPECT_EQ(memory.update({}), next);
  glm::vec3 value = next;
  for (int i = 0; i < 60; ++i) value = memory.update(grey(8.0f));
  EXPECT_NEAR(value.x, 8.0f, 1e-3f);
}

TEST(ExposureMemory, PaperGoesBeforeGreyCard) {
  ExposureMemory memory;
  const glm::vec3 paper(2.0f, 3.0f, 5.0f);
  EXPECT_EQ(memory.update({7.0f, paper}), paper);
}

// A hand over the marker: the light stays, and where it changes meanwhile, the grey card tells.
TEST(ExposureMemory, KeepsTheLightWhileThePaperIsHidden) {
  ExposureMemory memory;
  const glm::vec3 paper(2.0f, 3.0f, 5.0f);
  memory.update({6.0f, paper});
  glm::vec3 value(0.0f);
  for (int i = 0; i < 100; ++i) value = memory.update(grey(6.0f));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], paper[c], 1e-4f);
  for (int i = 0; i < 100; ++i) value = memory.update(grey(12.0f));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], 2.0f * paper[c], 1e-3f);
}

TEST(ExposureMemory, ChangesTheCurveOnlyOnStrongEvidence) {
  ExposureMemory memory;
  EXPECT_EQ(memory.update_curve(std::nullopt), ToneCurve::Reinhard);
  EXPECT_EQ(memory.update_curve(0.1f), ToneCurve::Linear) << "the first evidence counts";
  EXPECT_EQ(memory.update_curve(-0.3f), ToneCurve::Linear);
  EXPECT_EQ(memory.update_curve(std::nullopt), ToneCurve::Linear);
  memory.update(grey(4.0f));
  EXPECT_EQ(memory.update_curve(-0.8f), ToneCurve::Reinhard);
  EXPECT_EQ(memory.update(grey(9.0f)), glm::vec3(9.0f)) << "the old one was of the other curve";
}

}  // namespace
}  // namespace amalgam::passes
