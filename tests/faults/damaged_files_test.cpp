// Row 41: scenes whose files are cut or damaged are refused with one line, or read, within two
// seconds each.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "faults/figure.h"
#include "scene/gltf/loader.h"

namespace amalgam::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

const fs::path kScenes = AMALGAM_SOURCE_DIR "/deploy/scenes";

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A copy of a scene, whose files may be damaged one at a time.
class DamagedFiles : public testing::Test {
 protected:
  DamagedFiles()
      : folder_(fs::temp_directory_path() / ("amalgam-damage-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
    // Its geometry, textures and environment lie in files of their own.
    for (const char* name :
         {"complex.gltf", "complex.bin", "hammered.png", "marble.png", "environment.exr"}) {
      fs::copy_file(kScenes / name, folder_ / name, fs::copy_options::overwrite_existing);
    }
  }
  ~DamagedFiles() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  // What is said of the scene; empty if it is read.
  std::string load() {
    const auto begin = Clock::now();
    std::string said;
    try {
      scene::load_scene(folder_ / "complex.gltf");
    } catch (const scene::SceneError& error) {
      said = error.what();
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
    slowest_ = std::max(slowest_, std::chrono::duration<double>(Clock::now() - begin).count());
    return said;
  }

  fs::path folder_;
  double slowest_ = 0.0;  // seconds
};

TEST_F(DamagedFiles, AreReadOrRefusedInOneLineAndTwoSeconds) {
  ASSERT_EQ(load(), "") << "undamaged";
  std::mt19937 random(41);
  int cases = 0;
  struct File {
    const char* name;
    const char* element;  // that says which file it is
  };
  for (const auto& [name, element] :
       {File{"complex.gltf", "complex.gltf"}, File{"complex.bin", "buffers[0]"},
        File{"marble.png", "images[0]"}, File{"environment.exr", "environment.exr"}}) {
    const std::string good = read(folder_ / name);
    ASSERT_FALSE(good.empty()) << name;
    for (const double part : {0.0, 0.1, 0.5, 0.95}) {
      write(name,
            good.substr(0, static_cast<std::size_t>(part * static_cast<double>(good.size()))));
      const std::string said = load();
      EXPECT_NE(said, "") << name << " cut to " << part << " was read";
      EXPECT_NE(said.find(element), std::string::npos) << said;
      ++cases;
    }
    for (int i = 0; i < 4; ++i) {
      std::string damaged = good;
      for (int byte = 0; byte < 8; ++byte) {
        damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
      }
      write(name, damaged);
      load();
      ++cases;
    }
    fs::remove(folder_ / name);
    EXPECT_NE(load().find(name), std::string::npos) << "missing";
    write(name, good);
  }
  EXPECT_EQ(load(), "") << "mended";
  print_figure("41", "slowest of " + std::to_string(cases) + " damaged files", slowest_, "s",
               "<= 2 s");
  EXPECT_LT(slowest_, 2.0);
}

}  // namespace
}  // namespace amalgam::test
