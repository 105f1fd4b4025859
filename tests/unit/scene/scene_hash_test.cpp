#include "scene/gltf/scene_hash.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names(const fs::path& scene) {
  std::vector<std::string> names;
  for (const fs::path& file : files_of_scene(scene)) names.push_back(file.filename());
  return names;
}

class SceneHash : public testing::Test {
 protected:
  SceneHash() { fs::create_directories(folder_); }
  ~SceneHash() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  const fs::path folder_ = fs::temp_directory_path() / ("amalgam-hash-" + std::to_string(getpid()));
};

TEST_F(SceneHash, IsOfAllFilesThatASceneRefersTo) {
  const fs::path scenes = AMALGAM_SOURCE_DIR "/deploy/scenes";
  EXPECT_EQ(names(scenes / "mirror.gltf"),
            (std::vector<std::string>{"mirror.gltf", "environment.exr", "mirror.bin"}));
  const auto glassware = names(scenes / "glassware.gltf");
  EXPECT_EQ(std::set<std::string>(glassware.begin(), glassware.end()),
            (std::set<std::string>{"glassware.gltf", "glassware.bin", "hammered.png",
                                   "environment.exr"}));
}

// As the loader finds them: escaped, as they are, and in a text that is JSON. What is not there, is
// not in the folder or is no file counts by its name alone.
TEST_F(SceneHash, FindsFilesByTheLoadersNames) {
  for (const char* name : {"a b.bin", "c%d.png", "e.exr"}) write(name, "bytes");
  const fs::path scene = write("s.gltf", R"({"buffers": [{"uri": "a%20b.bin"}, {"uri": "gone.bin"},
    {"uri": "data:application/octet-stream;base64,AAAA"}, {"uri": "../../etc/passwd"}],
    "images": [{"uri": "c%d.png"}, {"uri": "a%20b.bin"}],
    "scenes": [{"extras": {"amalgam": "{\"environment\": \"e.exr\"}"}}], "nodes": [{"name": "e.exr"}]})");
  EXPECT_EQ(names(scene), (std::vector<std::string>{"s.gltf", "a b.bin", "c%d.png", "e.exr"}));
}

TEST_F(SceneHash, EachByteAndItsFileCount) {
  const auto hash_of = [&](const std::string& first, const std::string& second) {
    write("a", first);
    write("b", second);
    return scene_hash(write("s.gltf", R"({"buffers": [{"uri": "a"}, {"uri": "b"}]})"));
  };
  const std::string hash = hash_of("one", "two");
  EXPECT_EQ(hash.size(), 64u);
  EXPECT_EQ(hash_of("one", "two"), hash);
  EXPECT_NE(hash_of("one", "twp"), hash);
  EXPECT_NE(hash_of("onet", "wo"), hash);
  EXPECT_THROW(scene_hash(folder_ / "gone.gltf"), SceneError);
}

}  // namespace
}  // namespace amalgam::scene
