#include "unit/scene/gltf_sample.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>

namespace amalgam::scene {
namespace {

std::string sample_buffer() {
  const float numbers[] = {0, 0, 0, 1, 0, 0, 0, 1, 0,  // positions
                           0, 0, 1, 0, 0, 1, 0, 0, 1,  // normals
                           0, 0, 1, 0, 0, 1};          // texture coordinates
  const std::uint16_t indices[] = {0, 1, 2, 0};
  std::string bytes(sizeof numbers + sizeof indices, '\0');
  std::memcpy(bytes.data(), numbers, sizeof numbers);
  std::memcpy(bytes.data() + sizeof numbers, indices, sizeof indices);
  return bytes;
}

}  // namespace

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (int k = 0; k < 4; ++k) text += kDigits[group >> (18 - 6 * k) & 63];
  }
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  text.replace(text.size() - padding, padding, std::string(padding, '='));
  return text;
}

std::string sample_gltf() {
  return R"({
"asset": {"version": "2.0"},
"scene": 0,
"scenes": [{"nodes": [0]}],
"nodes": [{"name": "thing", "mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3, "material": 0}]}],
"materials": [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1], "metallicFactor": 0}}],
"accessors": [
{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
{"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2"},
{"bufferView": 3, "componentType": 5123, "count": 3, "type": "SCALAR"}],
"bufferViews": [
{"buffer": 0, "byteOffset": 0, "byteLength": 36},
{"buffer": 0, "byteOffset": 36, "byteLength": 36},
{"buffer": 0, "byteOffset": 72, "byteLength": 24},
{"buffer": 0, "byteOffset": 96, "byteLength": 8}],
"buffers": [{"byteLength": 104, "uri": "data:application/octet-stream;base64,)" +
         base64(sample_buffer()) + "\"}]}";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) {
    ADD_FAILURE() << "the sample has no " << from;
    return text;
  }
  return text.replace(at, from.size(), to);
}

std::filesystem::path test_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) / "amalgam_scene_test" /
                      (std::string(test->test_suite_name()) + "." + test->name());
  std::filesystem::create_directories(folder);
  return folder;
}

std::filesystem::path write_file(const std::string& name, const std::string& contents) {
  const auto path = test_folder() / name;
  std::ofstream(path, std::ios::binary) << contents;
  return path;
}

Scene load_text(const std::string& gltf) {
  return load_scene(write_file("sample.gltf", gltf));
}

std::string refusal_of(const std::string& gltf) {
  try {
    load_text(gltf);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace amalgam::scene
