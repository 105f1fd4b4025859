#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

// What programs do when nobody takes their output.

namespace amalgam::tests {
namespace {

namespace fs = std::filesystem;

int exit_code(const std::string& shell) {
  const int status = std::system(("bash -c '" + shell + "' 2>/dev/null").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string program(const std::string& name) {
  return std::string(AMALGAM_BINARY_DIR) + "/bin/" + name;
}

class ProgramOutput : public testing::TestWithParam<const char*> {};

TEST_P(ProgramOutput, AFullDiskIsAnError) {
  EXPECT_EQ(exit_code(program(GetParam()) + " --help > /dev/full"), 1);
  EXPECT_EQ(exit_code(program(GetParam()) + " --version > /dev/full"), 1);
  EXPECT_EQ(exit_code(program(GetParam()) + " --version > /dev/null"), 0);
}

TEST_P(ProgramOutput, AClosedPipeIsAnErrorAndNoSignal) {
  // The reader has gone before the program begins.
  EXPECT_EQ(exit_code("set -o pipefail; { sleep 0.2; " + program(GetParam()) + " --help; } | true"),
            1);
}

INSTANTIATE_TEST_SUITE_P(All, ProgramOutput,
                         testing::Values("amalgam-server", "amalgam-client", "amalgam-render",
                                         "amalgam-inspect", "amalgam-load", "amalgam-marker"));

TEST(ProgramOutput, ReportsAreComplete) {
  const std::string scene = AMALGAM_SOURCE_DIR "/deploy/scenes/diffuse.gltf";
  EXPECT_EQ(exit_code(program("amalgam-inspect") + " --json " + scene + " > /dev/full"), 1);
}

// A picture that cannot be written whole does not take its name. The limit is on file sizes.
TEST(ProgramOutput, HalfWrittenFilesAreRemoved) {
  const fs::path folder = fs::path(testing::TempDir()) / "amalgam_half_written";
  fs::remove_all(folder);
  fs::create_directories(folder);
  EXPECT_EQ(exit_code("trap \"\" XFSZ; ulimit -f 1; " + program("amalgam-marker") + " --output " +
                      (folder / "markers.svg").string()),
            1);
  EXPECT_TRUE(fs::is_empty(folder));
  EXPECT_EQ(exit_code(program("amalgam-marker") + " --output " + (folder / "markers.svg").string()),
            0);
  EXPECT_GT(fs::file_size(folder / "markers.svg"), 1024u);
}

}  // namespace
}  // namespace amalgam::tests
