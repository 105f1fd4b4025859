#include "common/check_context.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

#include "common/log.h"

namespace amalgam::common {
namespace {

TEST(CheckContext, IsThereForAsLongAsItsScope) {
  EXPECT_EQ(CheckContext::describe_all(), "");
  {
    int frame = 1;
    const CheckContext outer([&] { return "frame " + std::to_string(frame); });
    frame = 2;
    EXPECT_EQ(CheckContext::describe_all(), "frame 2\n");
    const CheckContext inner([] { return std::string("its shadow"); });
    EXPECT_EQ(CheckContext::describe_all(), "frame 2\nits shadow\n");
  }
  EXPECT_EQ(CheckContext::describe_all(), "");
}

TEST(CheckContext, AThreadSeesItsOwnAndAWorkerThoseOfTheOthers) {
  const CheckContext ours([] { return std::string("ours"); });
  std::string worker, other;
  std::thread([&] { worker = CheckContext::describe_all(); }).join();
  std::thread([&] {
    const CheckContext theirs([] { return std::string("theirs"); });
    other = CheckContext::describe_all();
  }).join();
  EXPECT_EQ(worker, "ours\n");
  EXPECT_EQ(other, "theirs\n");
}

TEST(CheckContext, ItsTextIsMadeOnlyWhenAskedFor) {
  int made = 0;
  {
    const CheckContext context([&] {
      ++made;
      return std::string();
    });
    AMALGAM_CHECK(true, std::string("fine"));
  }
  EXPECT_EQ(made, 0);
}

TEST(CheckContext, WhatCannotBeDescribedHidesNothing) {
  const CheckContext broken([]() -> std::string { throw std::runtime_error("no memory"); });
  const CheckContext asks_again([] { return "again: " + CheckContext::describe_all(); });
  EXPECT_EQ(CheckContext::describe_all(), "(cannot be described: no memory)\nagain: \n");
}

TEST(CheckContextDeathTest, AFailedCheckPrintsIt) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const CheckContext context([] { return std::string("rendering frame 7"); });
  const auto message = testing::AllOf(testing::HasSubstr("1 > 2"), testing::HasSubstr("one=1"),
                                      testing::HasSubstr("rendering frame 7"));
  EXPECT_DEATH(AMALGAM_CHECK(1 > 2, std::string("one=1")), message);
  EXPECT_DEATH(std::thread([] { AMALGAM_CHECK(1 > 2, std::string("one=1")); }).join(), message);
}

TEST(CheckContextDeathTest, ACheckThatFailsMeanwhileIsReportedToo) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const CheckContext context([]() -> std::string {
    AMALGAM_CHECK(3 > 4, std::string("second"));
    return {};
  });
  EXPECT_DEATH(AMALGAM_CHECK(1 > 2, std::string("first")),
               testing::AllOf(testing::HasSubstr("first"), testing::HasSubstr("second")));
}

}  // namespace
}  // namespace amalgam::common
