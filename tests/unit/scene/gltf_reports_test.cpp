#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scene/scene_error.h"
#include "support/test_data.h"
#include "unit/scene/gltf_sample.h"

// Files that people reported, and names that writers give to them.

namespace amalgam::scene {
namespace {

using testing::Contains;
using testing::HasSubstr;

class GltfReports : public testing::Test {
 protected:
  void SetUp() override {
    if (!tests::test_data()) GTEST_SKIP() << "test data not found";
  }
  static Scene load(const std::string& name) {
    return load_scene(*tests::test_data() / "reports" / name);
  }
};

// plain.glb is what gltfpack was given: a box's corners are where they were, to its 14 bits.
TEST_F(GltfReports, GltfpackKeepsTheCorners) {
  const auto bounds = [](const Scene& scene) {
    glm::dvec3 low(1e9), high(-1e9);
    for (const Instance& instance : scene.instances) {
      for (const glm::vec3& p : scene.meshes[instance.mesh].positions) {
        const glm::dvec3 q(instance.anchor_from_mesh * glm::dvec4(p, 1.0f));
        low = glm::min(low, q);
        high = glm::max(high, q);
      }
    }
    return std::pair(low, high);
  };
  const Scene plain = load("gltf-quantized/plain.glb"),
              packed = load("gltf-quantized/gltfpack.glb");
  EXPECT_EQ(packed.meshes.at(0).triangles.size(), plain.meshes.at(0).triangles.size());
  EXPECT_LT(glm::distance(bounds(packed).first, bounds(plain).first), 1e-3);
  EXPECT_LT(glm::distance(bounds(packed).second, bounds(plain).second), 1e-3);
  EXPECT_GT(glm::distance(bounds(plain).first, bounds(plain).second), 0.1);
}

TEST_F(GltfReports, WrongBoundsAreNoted) {
  for (const char* name : {"m_idx", "m_uv", "m_zero"}) {
    const Scene scene = load("gltf-bounds-wrong/" + std::string(name) + ".gltf");
    EXPECT_THAT(scene.notes, Contains(HasSubstr("is outside min and max"))) << name;
    EXPECT_GE(scene.meshes.at(0).triangles.size(), 1u) << name;
  }
}

TEST_F(GltfReports, EmptyListsAreNoted) {
  for (const char* name : {"anims", "children", "lights", "req", "scene"}) {
    const Scene scene = load("gltf-empty-arrays/s_empty" + std::string(name) + ".gltf");
    EXPECT_THAT(scene.notes, Contains(HasSubstr("is empty"))) << name;
    EXPECT_EQ(scene.instances.size(), 1u) << name;
  }
}

TEST_F(GltfReports, PlusIsAnOrdinaryCharacter) {
  EXPECT_EQ(load("gltf-plus-in-name/b_plus.gltf").meshes.size(), 1u);
  EXPECT_EQ(load("gltf-plus-in-name/t_plus.gltf").textures.size(), 1u);
}

TEST_F(GltfReports, BlendersSpotHasAHardEdge) {
  const Scene scene = load("gltf-spot-blend-0/spot0.gltf");
  ASSERT_EQ(scene.punctual_lights.size(), 1u);
  EXPECT_EQ(scene.punctual_lights[0].cos_inner, scene.punctual_lights[0].cos_outer);
  EXPECT_LT(scene.punctual_lights[0].cos_outer, 1.0f);
}

TEST_F(GltfReports, NodesOfScaleZeroAreNotDrawn) {
  for (const char* name : {"s_zeroscale", "s_zeroscaley"}) {
    const Scene scene = load("gltf-zero-scale/" + std::string(name) + ".gltf");
    EXPECT_EQ(scene.instances.size(), 1u) << name;
    EXPECT_THAT(scene.notes, Contains("nodes[1]: is scaled to nothing, not drawn")) << name;
  }
}

// The sample with its buffer in a file of this name.
Scene with_buffer_file(const std::string& uri, const std::string& file, bool longer = false) {
  const std::string text = sample_gltf();
  const std::size_t at = text.find("data:application"), end = text.find('"', at);
  std::string bytes;
  {
    const Scene sample = load_text(text);
    const Mesh& mesh = sample.meshes.at(0);
    const auto add = [&](const auto& values, std::size_t size) {
      bytes.append(reinterpret_cast<const char*>(values.data()), size);
    };
    add(mesh.positions, 36);
    add(mesh.normals, 36);
    bytes.append(24, '\0');
    add(std::vector<std::uint16_t>{0, 1, 2, 0}, 8);
  }
  write_file(file, longer ? bytes + "more" : bytes);
  return load_text(std::string(text).replace(at, end - at, uri));
}

TEST(GltfNames, MeanWhatTheySay) {
  const auto finds = [](const std::string& uri, const std::string& file) {
    const Scene scene = with_buffer_file(uri, file);
    std::filesystem::remove(test_folder() / file);
    return scene.meshes.at(0).positions.at(1) == glm::vec3(1, 0, 0) &&
           scene.notes == load_text(sample_gltf()).notes;
  };
  EXPECT_TRUE(finds("a+b.bin", "a+b.bin"));
  EXPECT_TRUE(finds("a%20b.bin", "a b.bin"));
  EXPECT_TRUE(finds("a b.bin", "a b.bin"));
  EXPECT_TRUE(finds("100%.bin", "100%.bin"));
  EXPECT_TRUE(finds("100%zz.bin", "100%zz.bin"));
  EXPECT_TRUE(finds("a%2Bb.bin", "a+b.bin"));
  EXPECT_TRUE(finds("%C3%A4.bin", "\xC3\xA4.bin"));
  EXPECT_TRUE(finds("a#b?c&d.bin", "a#b?c&d.bin"));
}

// A space in another file's name must not be taken for the plus.
TEST(GltfNames, PlusIsNoSpace) {
  write_file("a b.bin", "wrong");
  EXPECT_EQ(with_buffer_file("a+b.bin", "a+b.bin").meshes.size(), 1u);
  std::filesystem::remove(test_folder() / "a+b.bin");
  EXPECT_THAT(
      refusal_of(replaced(sample_gltf(), "data:application/octet-stream;base64,", "a+b.bin#")),
      HasSubstr("No such file"));
}

TEST(GltfNames, UnescapedOnesAreFoundAndNoted) {
  const Scene raw = with_buffer_file("a%20b.bin", "a%20b.bin");
  EXPECT_THAT(raw.notes, Contains("buffers[0].uri: is not escaped as a URI"));
  std::filesystem::create_directories(test_folder() / "sub");
  const Scene windows = with_buffer_file(R"(sub\\c.bin)", "sub/c.bin");
  EXPECT_THAT(windows.notes, Contains("buffers[0].uri: is not escaped as a URI"));
  EXPECT_EQ(windows.meshes.at(0).positions.at(1), glm::vec3(1, 0, 0));
}

TEST(GltfNames, FilesMayBeLongerThanDeclared) {
  EXPECT_EQ(with_buffer_file("long.bin", "long.bin", true).meshes.size(), 1u);
  write_file("short.bin", "short");
  const std::string text = sample_gltf();
  const std::size_t at = text.find("data:application"), end = text.find('"', at);
  EXPECT_THAT(refusal_of(std::string(text).replace(at, end - at, "short.bin")),
              HasSubstr("byteLength is 104, but there are 5 bytes"));
}

}  // namespace
}  // namespace amalgam::scene
