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

// Errors name the key and not the JSON library.
TEST(ProgramOutput, ErrorsOfPosesNameTheKey) {
  const fs::path folder = fs::path(testing::TempDir()) / "amalgam_poses_errors";
  fs::create_directories(folder);
  for (const auto& [json, says] :
       {std::pair("{}", "has no .poses."),
        {"[1]", "has no .poses."},
        {"{", "is not JSON"},
        {"{\"poses\": 3}", ".poses. is not a list"},
        {"{\"poses\": [{\"marker\": 1, \"rotation\": [0,0,1], \"translation\": [0,0,0]}]}",
         "poses.0.: .rotation. is not 4 numbers"},
        {"{\"poses\": [{\"marker\": \"x\", \"rotation\": [0,0,0,1], \"translation\": [0,0,0]}]}",
         "poses.0.: .marker. is not a number"}}) {
    std::ofstream(folder / "poses.json") << json;
    EXPECT_EQ(
        exit_code(program("amalgam-render") + " --renderer raytrace --size 16x16 --scene " +
                  AMALGAM_SOURCE_DIR "/deploy/scenes/diffuse.gltf --poses " +
                  (folder / "poses.json").string() + " 2>&1 >/dev/null | grep -q \"" + says + "\""),
        0)
        << json;
  }
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
