// Machines without OpenGL: one line says what helps, and tracing needs nothing.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "support/child_process.h"

namespace amalgam::tests {
namespace {

namespace fs = std::filesystem;
constexpr std::chrono::seconds kPatience(60);

struct Ended {
  std::string said;
  int code = 0;
};

// With an environment variable for this process alone.
Ended run(const std::string& variable, const std::string& value, const std::string& program,
          std::vector<std::string> arguments) {
  setenv(variable.c_str(), value.c_str(), 1);
  ChildProcess process(program, std::move(arguments), ChildProcess::Reads::OutputAndErrors);
  unsetenv(variable.c_str());
  Ended ended;
  ended.said = process.read_all(kPatience);
  ended.code = process.wait(kPatience);
  return ended;
}

class WithoutOpenGl : public testing::Test {
 protected:
  WithoutOpenGl()
      : folder_(fs::temp_directory_path() /
                ("amalgam-without-opengl-" + std::to_string(getpid()) +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
  }
  ~WithoutOpenGl() override { fs::remove_all(folder_); }

  std::vector<std::string> render(const std::string& renderer) const {
    return {"--scene",    scene_,   "--size",   "32x24",
            "--renderer", renderer, "--output", (folder_ / "out.png").string()};
  }

  // One line, exit 1, and what to do.
  static void expect_advice(const Ended& run) {
    EXPECT_EQ(run.code, 1) << run.said;
    EXPECT_EQ(std::count(run.said.begin(), run.said.end(), '\n'), 1) << run.said;
    for (const char* part :
         {"no OpenGL 4.5 context", "libegl1", "libgl1-mesa-dri", "--renderer raytrace"}) {
      EXPECT_NE(run.said.find(part), std::string::npos) << part << " in " << run.said;
    }
  }

  const std::string scene_ = AMALGAM_SOURCE_DIR "/deploy/scenes/mirror.gltf";
  const fs::path folder_;
};

// libEGL is there and finds no driver.
TEST_F(WithoutOpenGl, WithoutADriver) {
  const char* variable = "__EGL_VENDOR_LIBRARY_DIRS";
  expect_advice(run(variable, "/nonexistent", "amalgam-render", render("hybrid")));
  const Ended traced = run(variable, "/nonexistent", "amalgam-render", render("raytrace"));
  EXPECT_EQ(traced.code, 0) << traced.said;
  EXPECT_TRUE(fs::exists(folder_ / "out.png"));
}

// An empty file stands before the real library, which is then as good as missing.
TEST_F(WithoutOpenGl, WithoutTheLibrary) {
  std::ofstream(folder_ / "libEGL.so.1");
  const char* variable = "LD_LIBRARY_PATH";
  expect_advice(run(variable, folder_.string(), "amalgam-render", render("hybrid")));
  const Ended traced = run(variable, folder_.string(), "amalgam-render", render("raytrace"));
  EXPECT_EQ(traced.code, 0) << traced.said;
}

// The server makes its context on a thread of its own.
TEST_F(WithoutOpenGl, TheServerSaysItToo) {
  const Ended server = run("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", "amalgam-server",
                           {"--scene", scene_, "--listen", "127.0.0.1:0", "--admin", "127.0.0.1:0",
                            "--log-level", "error"});
  EXPECT_EQ(server.code, 1) << server.said;
  EXPECT_NE(server.said.find("--renderer raytrace"), std::string::npos) << server.said;
}

}  // namespace
}  // namespace amalgam::tests
