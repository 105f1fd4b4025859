#include "scene/gltf/loader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "unit/scene/gltf_sample.h"

namespace amalgam::scene {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST(GltfLoader, ReadsTheSample) {
  const Scene scene = load_text(sample_gltf());
  ASSERT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.instances[0].node, "thing");
  EXPECT_EQ(scene.instances[0].role, Role::Virtual);
  EXPECT_FALSE(scene.instances[0].marker);
  ASSERT_EQ(scene.meshes.size(), 1u);
  const Mesh& mesh = scene.meshes[0];
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2));
  EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0));
  EXPECT_EQ(mesh.normals[1], glm::vec3(0, 0, 1));
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].base_color, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(scene.materials[0].kind, MaterialKind::Diffuse);
  EXPECT_TRUE(scene.notes.empty()) << scene.notes.front();
  EXPECT_FALSE(scene.environment);
}

TEST(GltfLoader, TransformsMultiplyDownTheTree) {
  const Scene scene =
      load_text(replaced(sample_gltf(), R"("nodes": [{"name": "thing", "mesh": 0}])",
                         R"("nodes": [{"translation": [1, 2, 3], "children": [1]},
                   {"name": "thing", "mesh": 0, "scale": [2, 2, 2], "rotation": [0, 0.70710678, 0, 0.70710678]}])"));
  ASSERT_EQ(scene.instances.size(), 1u);
  const glm::dvec4 corner = scene.instances[0].anchor_from_mesh * glm::dvec4(1, 0, 0, 1);
  EXPECT_NEAR(corner.x, 1.0f, 1e-5f);  // +X turned by 90 degrees about +Y is -Z
  EXPECT_NEAR(corner.y, 2.0f, 1e-5f);
  EXPECT_NEAR(corner.z, 1.0f, 1e-5f);
}

// numerics B13: as floats, the two nodes' places would add up to a sixteenth of a metre only.
TEST(GltfLoader, PlacesFarFromTheMarkerKeepTheirDigits) {
  const Scene scene =
      load_text(replaced(sample_gltf(), R"("nodes": [{"name": "thing", "mesh": 0}])",
                         R"("nodes": [{"translation": [1000000, 0, 0], "children": [1]},
                   {"name": "thing", "mesh": 0, "translation": [0.3, 0, 0]}])"));
  EXPECT_EQ(scene.instances.at(0).anchor_from_mesh[3].x, 1000000.3);
}

// Positions and colors side by side in one view; colors as bytes, of which 255 is 1.
TEST(GltfLoader, ReadsInterleavedAndNormalizedNumbers) {
  struct Vertex {
    float position[3];
    std::uint8_t color[4];
  };
  const Vertex vertices[] = {
      {{0, 0, 0}, {255, 0, 51, 255}}, {{1, 0, 0}, {0, 102, 0, 255}}, {{0, 1, 0}, {0, 0, 0, 0}}};
  std::string bytes(sizeof vertices, '\0');
  std::memcpy(bytes.data(), vertices, sizeof vertices);
  std::string gltf = sample_gltf();
  gltf = replaced(gltf, "\"}]}",
                  "\"},\n{\"byteLength\": 48, \"uri\": "
                  "\"data:application/octet-stream;base64," +
                      base64(bytes) + "\"}]}");
  gltf = replaced(gltf, R"("byteOffset": 96, "byteLength": 8})",
                  R"("byteOffset": 96, "byteLength": 8},
                     {"buffer": 1, "byteLength": 48, "byteStride": 16})");
  gltf = replaced(gltf, R"("accessors": [
{"bufferView": 0,)",
                  R"("accessors": [
{"bufferView": 4,)");
  gltf = replaced(gltf, R"("type": "SCALAR"})", R"("type": "SCALAR"},
{"bufferView": 4, "byteOffset": 12, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC4"})");
  gltf = replaced(gltf, R"("NORMAL": 1,)", R"("NORMAL": 1, "COLOR_0": 4,)");
  const Mesh mesh = load_text(gltf).meshes.at(0);
  ASSERT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
  EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 0));
  ASSERT_EQ(mesh.colors.size(), 3u);
  EXPECT_EQ(mesh.colors[0], glm::vec4(1.0f, 0.0f, 0.2f, 1.0f));
  EXPECT_EQ(mesh.colors[1], glm::vec4(0.0f, 0.4f, 0.0f, 1.0f));
  EXPECT_EQ(mesh.colors[2], glm::vec4(0.0f));
}

TEST(GltfLoader, AMeshUsedTwiceIsStoredOnce) {
  const Scene scene = load_text(replaced(
      replaced(sample_gltf(), R"({"name": "thing", "mesh": 0})", R"({"mesh": 0}, {"mesh": 0})"),
      R"({"nodes": [0]})", R"({"nodes": [0, 1]})"));
  EXPECT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.instances[1].node, "nodes[1]");
}

TEST(GltfLoader, OnlyTheDefaultSceneIsRead) {
  const std::string two =
      replaced(replaced(sample_gltf(), R"({"name": "thing", "mesh": 0})",
                        R"({"mesh": 0}, {"name": "other", "mesh": 0})"),
               R"([{"nodes": [0]}])",
               R"([{"nodes": [0]}, {"nodes": [1], "extras": {"amalgam": {"world_marker": 5}}}])");
  EXPECT_EQ(load_text(two).world.marker, 0);
  const Scene second = load_text(replaced(two, R"("scene": 0)", R"("scene": 1)"));
  EXPECT_EQ(second.world.marker, 5);
  ASSERT_EQ(second.instances.size(), 1u);
  EXPECT_EQ(second.instances[0].node, "other");
}

TEST(GltfLoader, WithoutScenesAllRootsAreRead) {
  std::string text = replaced(sample_gltf(), "\"scene\": 0,\n", "");
  text = replaced(text, "\"scenes\": [{\"nodes\": [0]}],\n", "");
  EXPECT_EQ(load_text(text).instances.size(), 1u);
}

TEST(GltfLoader, StripsAndFansBecomeTrianglesOfOneWinding) {
  // Four corners of a square: three positions of the sample and one more index.
  const std::string strip =
      replaced(replaced(sample_gltf(), R"("indices": 3,)", R"("indices": 3, "mode": 5,)"),
               R"("count": 3, "type": "SCALAR")", R"("count": 4, "type": "SCALAR")");
  // Indices 0 1 2 0: the second triangle (1 0 2) repeats no index within itself: 2 1 0 turned is 1
  // 0 2.
  const Scene scene = load_text(strip);
  ASSERT_EQ(scene.meshes[0].triangles.size(), 2u);
  EXPECT_EQ(scene.meshes[0].triangles[0], glm::uvec3(0, 1, 2));
  EXPECT_EQ(scene.meshes[0].triangles[1], glm::uvec3(1, 0, 2));
  const Scene fan =
      load_text(replaced(sample_gltf(), R"("indices": 3,)", R"("indices": 3, "mode": 6,)"));
  ASSERT_EQ(fan.meshes[0].triangles.size(), 1u);
  EXPECT_EQ(fan.meshes[0].triangles[0], glm::uvec3(1, 2, 0));
}

TEST(GltfLoader, LinesAreNotedAndLeftOut) {
  const Scene scene =
      load_text(replaced(sample_gltf(), R"("indices": 3,)", R"("indices": 3, "mode": 1,)"));
  EXPECT_TRUE(scene.instances.empty());
  EXPECT_THAT(scene.notes, Contains(HasSubstr("points and lines")));
}

TEST(GltfLoader, MissingNormalsAreComputed) {
  const Scene scene = load_text(replaced(sample_gltf(), R"("NORMAL": 1, )", ""));
  EXPECT_EQ(scene.meshes[0].normals, std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
  EXPECT_THAT(scene.notes, Contains(HasSubstr("no normals")));
}

TEST(GltfLoader, BinaryAndTextFilesGiveTheSame) {
  std::string json = replaced(sample_gltf(), R"(, "uri": "data:)", R"(, "extras": "data:)");
  // The same buffer as a BIN chunk: decoded here from what the text file carries.
  const Scene text = load_text(sample_gltf());
  const std::size_t from = json.find("base64,") + 7, to = json.find('"', from);
  std::string bin;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : json.substr(from, to - from)) {
    if (c == '=') break;
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    bits = bits << 6 | static_cast<std::uint32_t>(kDigits.find(c));
    count += 6;
    if (count >= 8) bin += static_cast<char>(bits >> (count -= 8) & 255);
  }
  ASSERT_EQ(bin.size(), 104u);
  json.append((4 - json.size() % 4) % 4, ' ');
  const auto u32 = [](std::size_t n) {
    std::string s;
    for (int i = 0; i < 4; ++i) s += static_cast<char>(n >> (8 * i) & 255);
    return s;
  };
  const std::string glb = "glTF" + u32(2) + u32(12 + 8 + json.size() + 8 + bin.size()) +
                          u32(json.size()) + "JSON" + json + u32(bin.size()) +
                          std::string("BIN\0", 4) + bin;
  const Scene binary = load_scene(write_file("sample.glb", glb));
  EXPECT_EQ(binary.meshes[0].positions, text.meshes[0].positions);
  EXPECT_EQ(binary.meshes[0].triangles, text.meshes[0].triangles);
}

TEST(GltfLoader, BuffersInFilesAreReadFromTheScenesFolderOnly) {
  const std::string text = sample_gltf();
  const std::size_t at = text.find("data:application"), end = text.find('"', at);
  const auto with_uri = [&](const std::string& uri) {
    return std::string(text).replace(at, end - at, uri);
  };
  write_file("a b.bin", std::string(104, '\0'));
  EXPECT_TRUE(load_text(with_uri("a%20b.bin")).instances.empty());  // all zeros: nothing is left
  EXPECT_THAT(refusal_of(with_uri("missing.bin")), HasSubstr("missing.bin"));
  EXPECT_THAT(refusal_of(with_uri("../../../../../../../../../../etc/passwd")),
              HasSubstr("outside"));
  EXPECT_THAT(refusal_of(with_uri("/etc/passwd")), HasSubstr("absolute"));
  EXPECT_THAT(refusal_of(with_uri("file:///etc/passwd")), HasSubstr("scheme"));
  EXPECT_THAT(refusal_of(with_uri("%2Fetc/passwd")), HasSubstr("absolute"));
  std::error_code error;
  std::filesystem::remove(test_folder() / "link.bin", error);
  std::filesystem::create_symlink("/etc/passwd", test_folder() / "link.bin");
  EXPECT_THAT(refusal_of(with_uri("link.bin")), HasSubstr("outside"));
}

TEST(GltfLoader, EnvironmentsComeFromTheSceneOrTheOptions) {
  const std::string text =
      replaced(sample_gltf(), R"({"nodes": [0]})",
               R"({"nodes": [0], "extras": {"amalgam": {"environment": "../x.exr"}}})");
  EXPECT_THAT(refusal_of(text), HasSubstr("x.exr"));
  LoadOptions options;
  options.load_environment = false;
  EXPECT_FALSE(load_scene(write_file("sample.gltf", text), options).environment);
  options.environment = AMALGAM_SOURCE_DIR "/deploy/scenes/environment.exr";
  EXPECT_TRUE(load_scene(write_file("sample.gltf", text), options).environment);
}

TEST(GltfLoader, TexturesAreDecodedAndCoordinatesTransformed) {
  std::filesystem::copy_file(AMALGAM_SOURCE_DIR "/deploy/scenes/marble.png",
                             test_folder() / "marble.png",
                             std::filesystem::copy_options::overwrite_existing);
  const std::string text =
      replaced(replaced(sample_gltf(), R"("metallicFactor": 0)",
                        R"("metallicFactor": 0, "baseColorTexture": {"index": 0,
        "extensions": {"KHR_texture_transform": {"offset": [0.5, 0.25], "scale": [2, 3]}}})"),
               R"("accessors")",
               R"("images": [{"uri": "marble.png"}], "samplers": [{"wrapS": 33071, "wrapT": 33648}],
        "textures": [{"source": 0, "sampler": 0}], "extensionsUsed": ["KHR_texture_transform"], "accessors")");
  const Scene scene = load_text(text);
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].texels.size(), glm::ivec2(128, 128));
  EXPECT_EQ(scene.textures[0].wrap_u, Wrap::Clamp);
  EXPECT_EQ(scene.textures[0].wrap_v, Wrap::Mirror);
  EXPECT_EQ(scene.materials[0].base_color_texture, 0u);
  const std::vector<glm::vec2> expected{{0.5f, 0.25f}, {2.5f, 0.25f}, {0.5f, 3.25f}};
  EXPECT_EQ(scene.meshes[0].uvs, expected);
}

TEST(GltfLoader, ErrorsNameFileAndElementInOneLine) {
  const std::string message =
      refusal_of(replaced(sample_gltf(), R"("indices": 3)", R"("indices": 17)"));
  EXPECT_THAT(message, HasSubstr("sample.gltf"));
  EXPECT_THAT(message, HasSubstr("meshes[0].primitives[0].indices"));
  EXPECT_THAT(message, HasSubstr("17"));
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_THROW(load_scene("/nowhere/at/all.gltf"), SceneError);
}

}  // namespace
}  // namespace amalgam::scene
