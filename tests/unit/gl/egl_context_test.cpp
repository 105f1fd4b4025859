#include "gl/egl_context.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace amalgam::gl {
namespace {

// A new process, since EGL looks for its drivers once. No driver can be loaded there.
TEST(EglContextDeathTest, SaysEverythingItTried) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto start_without_drivers = [] {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json", 1);
    try {
      const EglContext context;
    } catch (const std::runtime_error& error) {
      std::fputs(error.what(), stderr);
      std::exit(3);
    }
    std::exit(0);
  };
  EXPECT_EXIT(start_without_drivers(), testing::ExitedWithCode(3),
              "no OpenGL 4.5 context without a window .*; tried "
              "surfaceless.*device.*default display");
}

TEST(EglContext, NamesItsDriver) {
  const EglContext context;
  EXPECT_FALSE(context.platform().empty());
  EXPECT_FALSE(context.vendor().empty());
  EXPECT_FALSE(context.renderer().empty());
  EXPECT_GE(context.version().substr(0, 3), "4.5");
}

TEST(EglContext, MayBeMadeAgainAndTwiceAtATime) {
  { const EglContext first; }
  const EglContext second;
  const EglContext third;
  EXPECT_EQ(second.renderer(), third.renderer());
}

TEST(EglContextDeathTest, BelongsToOneThread) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto use_elsewhere = [] {
    const EglContext context;
    std::thread([&] { context.check_thread(); }).join();
  };
  EXPECT_DEATH(use_elsewhere(), "another thread");
}

}  // namespace
}  // namespace amalgam::gl
