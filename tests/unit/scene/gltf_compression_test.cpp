#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <webp/encode.h>

#include <cmath>
#include <cstring>
#include <random>

#include "scene/gltf/compressed_data.h"
#include "unit/scene/gltf_sample.h"

// The sample's triangle in every compression: positions, normals and indices are the same.

namespace amalgam::scene {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::vector<glm::vec3> kPositions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

template <typename T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::string data_uri(const std::string& bytes,
                     const std::string& type = "application/octet-stream") {
  return "data:" + type + ";base64," + base64(bytes);
}

// A file of one triangle around the given parts; one line an element.
std::string document(const std::string& attributes, const std::string& accessors,
                     const std::string& views, const std::string& buffers,
                     const std::string& more = "") {
  return R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {)" +
         attributes + R"(}, "indices": 0)" + more + R"(}]}],
"accessors": [)" +
         accessors + "],\n\"bufferViews\": [" + views + "],\n\"buffers\": [" + buffers + "]}";
}

std::string requiring(const std::string& extension, std::string text) {
  return replaced(std::move(text), R"("scenes")",
                  R"("extensionsUsed": [")" + extension + R"("], "extensionsRequired": [")" +
                      extension + R"("], "scenes")");
}

void expect_triangle(const Scene& scene, float tolerance = 0.0f) {
  ASSERT_EQ(scene.meshes.size(), 1u);
  const Mesh& mesh = scene.meshes[0];
  ASSERT_EQ(mesh.triangles.size(), 1u);
  // Encoders may turn the triangle and reorder its vertices.
  glm::vec3 sum(0.0f);
  for (int i = 0; i < 3; ++i) {
    const glm::vec3 corner = mesh.positions.at(mesh.triangles[0][i]);
    sum += corner;
    float nearest = 1e9f;
    for (const glm::vec3& p : kPositions) nearest = std::min(nearest, glm::distance(p, corner));
    EXPECT_LE(nearest, tolerance);
    EXPECT_NEAR(glm::distance(mesh.normals.at(mesh.triangles[0][i]), {0, 0, 1}), 0.0f, 0.02f);
  }
  EXPECT_LE(glm::distance(sum, {1, 1, 0}), 3.0f * tolerance);
}

// Shorts as positions and bytes as normals, with a scale at the node: what gltfpack writes.
std::string quantized() {
  const std::vector<std::uint16_t> positions{0, 0, 0, 0, 1000, 0, 0, 0, 0, 1000, 0, 0};
  const std::vector<std::int8_t> normals{0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0};
  const std::vector<std::uint16_t> indices{0, 1, 2, 0};
  std::string text = document(
      R"("POSITION": 1, "NORMAL": 2)",
      R"({"bufferView": 0, "componentType": 5123, "count": 3, "type": "SCALAR"},
{"bufferView": 1, "componentType": 5123, "count": 3, "type": "VEC3", "min": [0,0,0], "max": [1000,1000,0]},
{"bufferView": 2, "componentType": 5120, "normalized": true, "count": 3, "type": "VEC3"})",
      R"({"buffer": 0, "byteLength": 8}, {"buffer": 0, "byteOffset": 8, "byteLength": 24, "byteStride": 8},
{"buffer": 0, "byteOffset": 32, "byteLength": 12, "byteStride": 4})",
      R"({"byteLength": 44, "uri": ")" +
          data_uri(bytes_of(indices) + bytes_of(positions) + bytes_of(normals)) + "\"}");
  return replaced(text, R"({"mesh": 0})", R"({"mesh": 0, "scale": [0.001, 0.001, 0.001]})");
}

TEST(GltfCompression, QuantizedVerticesAreRead) {
  const Scene scene = load_text(requiring("KHR_mesh_quantization", quantized()));
  EXPECT_TRUE(scene.notes.empty()) << scene.notes[0];
  EXPECT_EQ(scene.meshes.at(0).positions[1], glm::vec3(1000, 0, 0));
  EXPECT_EQ(scene.meshes.at(0).normals[1], glm::vec3(0, 0, 1));
  const glm::dvec4 corner = scene.instances.at(0).anchor_from_mesh * glm::dvec4(1000, 0, 0, 1);
  EXPECT_NEAR(corner.x, 1.0, 1e-12);
  EXPECT_THAT(load_text(quantized()).notes, Contains(HasSubstr("which is not declared")));
  // Unsigned normals would point to one side only.
  EXPECT_THAT(refusal_of(replaced(quantized(), "5120", "5121")), HasSubstr("format"));
}

// Positions and normals in one compressed view, indices in another.
struct Meshopt {
  std::string vertices, indices;
};

Meshopt encode_meshopt() {
  std::vector<glm::vec3> interleaved;
  for (const glm::vec3& p : kPositions) {
    interleaved.push_back(p);
    interleaved.emplace_back(0, 0, 1);
  }
  std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(3, 24));
  vertices.resize(
      meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), interleaved.data(), 3, 24));
  const std::vector<std::uint32_t> order{0, 1, 2};
  std::vector<unsigned char> indices(meshopt_encodeIndexBufferBound(3, 3));
  indices.resize(meshopt_encodeIndexBuffer(indices.data(), indices.size(), order.data(), 3));
  return {bytes_of(vertices), bytes_of(indices)};
}

std::string with_meshopt(const Meshopt& data) {
  const auto view = [](std::size_t offset, std::size_t bytes, int stride, const char* mode) {
    return R"("extensions": {"EXT_meshopt_compression": {"buffer": 0, "count": 3, "mode": ")" +
           std::string(mode) + R"(", "byteOffset": )" + std::to_string(offset) +
           R"(, "byteLength": )" + std::to_string(bytes) + R"(, "byteStride": )" +
           std::to_string(stride) + "}}";
  };
  return requiring(
      "EXT_meshopt_compression",
      document(R"("POSITION": 1, "NORMAL": 2)",
               R"({"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"},
{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 0, "byteOffset": 12, "componentType": 5126, "count": 3, "type": "VEC3"})",
               R"({"buffer": 1, "byteLength": 72, "byteStride": 24, )" +
                   view(0, data.vertices.size(), 24, "ATTRIBUTES") +
                   R"(}, {"buffer": 1, "byteOffset": 72, "byteLength": 6, )" +
                   view(data.vertices.size(), data.indices.size(), 2, "TRIANGLES") + "}",
               R"({"byteLength": )" + std::to_string(data.vertices.size() + data.indices.size()) +
                   R"(, "uri": ")" + data_uri(data.vertices + data.indices) + R"("},
{"byteLength": 78, "extensions": {"EXT_meshopt_compression": {"fallback": true}}})"));
}

TEST(GltfCompression, MeshoptIsRead) {
  expect_triangle(load_text(with_meshopt(encode_meshopt())));
}

TEST(GltfCompression, MeshoptThatTheLibraryWouldNotCheckIsRefused) {
  const std::string right = with_meshopt(encode_meshopt());
  const auto refusal = [&](const std::string& from, const std::string& to) {
    return refusal_of(replaced(right, from, to));
  };
  EXPECT_THAT(refusal(R"("byteStride": 24}})", R"("byteStride": 23}})"), HasSubstr("byteStride"));
  EXPECT_THAT(refusal(R"("count": 3, "mode")", R"("count": 4, "mode")"),
              HasSubstr("another length"));
  EXPECT_THAT(refusal(R"("mode": "ATTRIBUTES")", R"("mode": "OTHER")"), HasSubstr("is unknown"));
  EXPECT_THAT(refusal(R"("mode": "ATTRIBUTES")", R"("mode": "ATTRIBUTES", "filter": "OCTAHEDRAL")"),
              HasSubstr("filter"));
  EXPECT_THAT(refusal(R"("byteOffset": 0, )", R"("byteOffset": 9999, )"), HasSubstr("beyond"));
  EXPECT_THAT(refusal(R"({"buffer": 1, "byteLength": 72)", R"({"buffer": 1, "byteLength": 78},
                      {"buffer": 1, "byteLength": 72)"),
              HasSubstr("without data"));
}

// Octahedral normals and exponential positions, whose filters run after the decoder.
TEST(GltfCompression, MeshoptFiltersAreUndone) {
  std::vector<float> normal{0.6f, 0.0f, 0.8f, 0.0f};
  std::vector<unsigned char> filtered(4);
  meshopt_encodeFilterOct(filtered.data(), 1, 4, 8, normal.data());
  std::string normals = bytes_of(filtered);
  normals = normals + normals + normals;
  std::vector<unsigned char> encoded(meshopt_encodeVertexBufferBound(3, 4));
  encoded.resize(meshopt_encodeVertexBuffer(encoded.data(), encoded.size(), normals.data(), 3, 4));
  std::string text = replaced(
      quantized(), R"({"buffer": 0, "byteOffset": 32, "byteLength": 12, "byteStride": 4})",
      R"({"buffer": 2, "byteLength": 12, "byteStride": 4, "extensions": {"EXT_meshopt_compression":
        {"buffer": 1, "byteLength": )" +
          std::to_string(encoded.size()) +
          R"(, "byteStride": 4, "count": 3, "mode": "ATTRIBUTES", "filter": "OCTAHEDRAL"}}})");
  text = replaced(text, R"("buffers": [)",
                  R"("buffers": [{"byteLength": 12, "extensions": {"EXT_meshopt_compression": {}}},
{"byteLength": )" + std::to_string(encoded.size()) +
                      R"(, "uri": ")" + data_uri(bytes_of(encoded)) + "\"}, ");
  // The quantized file's own buffer is the third now.
  text = replaced(
      replaced(text, R"({"buffer": 0, "byteLength": 8})", R"({"buffer": 9, "byteLength": 8})"),
      R"({"buffer": 0, "byteOffset": 8)", R"({"buffer": 9, "byteOffset": 8)");
  text = replaced(replaced(replaced(text, R"("buffer": 2)", R"("buffer": 0)"), R"("buffer": 9)",
                           R"("buffer": 2)"),
                  R"("buffer": 9)", R"("buffer": 2)");
  const Scene scene = load_text(text);
  const glm::vec3 read = scene.meshes.at(0).normals.at(0);
  EXPECT_LT(glm::distance(read, {0.6f, 0.0f, 0.8f}), 0.02f);
}

// The triangle, and more of the same above it.
std::string encode_draco(bool quantize, int triangles = 1) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(triangles);
  const int position =
      builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int normal = builder.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32);
  const glm::vec3 up(0, 0, 1);
  for (int i = 0; i < triangles; ++i) {
    const draco::FaceIndex face(static_cast<std::uint32_t>(i));
    const glm::vec3 height(0, 0, i);
    const glm::vec3 a = kPositions[0] + height, b = kPositions[1] + height,
                    c = kPositions[2] + height;
    builder.SetAttributeValuesForFace(position, face, &a, &b, &c);
    builder.SetAttributeValuesForFace(normal, face, &up, &up, &up);
  }
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  if (quantize) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

std::string with_draco(const std::string& data) {
  return requiring(
      "KHR_draco_mesh_compression",
      document(R"("POSITION": 1, "NORMAL": 2)",
               R"({"componentType": 5123, "count": 3, "type": "SCALAR"},
{"componentType": 5126, "count": 3, "type": "VEC3", "min": [0,0,0], "max": [1,1,0]},
{"componentType": 5126, "count": 3, "type": "VEC3"})",
               R"({"buffer": 0, "byteLength": )" + std::to_string(data.size()) + "}",
               R"({"byteLength": )" + std::to_string(data.size()) + R"(, "uri": ")" +
                   data_uri(data) + "\"}",
               R"(, "extensions": {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes":
                {"POSITION": 0, "NORMAL": 1}}})"));
}

TEST(GltfCompression, DracoIsRead) {
  expect_triangle(load_text(with_draco(encode_draco(false))));
  expect_triangle(load_text(with_draco(encode_draco(true))), 1e-4f);
}

TEST(GltfCompression, DracoWithWrongAttributesIsRefused) {
  const std::string right = with_draco(encode_draco(true));
  EXPECT_THAT(refusal_of(replaced(right, R"("NORMAL": 1}})", R"("NORMAL": 7}})")),
              HasSubstr("no such attribute"));
  EXPECT_THAT(refusal_of(replaced(right, R"("NORMAL": 1}})", R"("COLOR_0": 1}})")),
              HasSubstr("is no attribute of its primitive"));
}

// An attribute beside the block keeps its own accessor, whose number nothing else compares.
TEST(GltfCompression, DracoAndAttributesBesideItMustAgree) {
  const auto with_zero_normals = [](int triangles) {
    return refusal_of(
        replaced(with_draco(encode_draco(false, triangles)), R"(, "NORMAL": 1}})", "}}"));
  };
  EXPECT_EQ(with_zero_normals(1), "accepted");
  EXPECT_THAT(with_zero_normals(2), HasSubstr("meshes[0].primitives[0]: its attributes have "
                                              "different numbers of vertices"));
}

TEST(GltfCompression, DracoOfAnAttributeWithoutAnAccessorIsNotFollowed) {
  for (const char* wrong : {"99", "-1", "2000000000"}) {
    std::string text = replaced(with_draco(encode_draco(false)), R"("NORMAL": 2)",
                                R"("NORMAL": 2, "_own": )" + std::string(wrong));
    text = replaced(text, R"("NORMAL": 1}})", R"("NORMAL": 1, "_own": 1}})");
    const Scene scene = load_text(text);
    expect_triangle(scene);
    EXPECT_THAT(scene.notes, Contains(HasSubstr("_own"))) << wrong;
  }
}

// What is not in the block has no data.
TEST(GltfCompression, DracoStandsForItsOwnAttributesOnly) {
  std::string text = with_draco(encode_draco(false));
  for (int i = 0; i < 2; ++i)
    text = replaced(text, R"("count": 3, "type": "VEC3")", R"("count": 2000000, "type": "VEC3")");
  EXPECT_EQ(refusal_of(text), "accepted");
  EXPECT_THAT(refusal_of(replaced(text, R"(, "NORMAL": 1}})", "}}")),
              HasSubstr("NORMAL: has more than a million elements and no data"));
}

// The file's only primitive as often as that.
std::string with_primitives(const std::string& text, int count) {
  const std::size_t begin = text.find(R"({"attributes")");
  const std::size_t end = text.find("}]}],\n\"accessors\"") + 1;
  std::string more;
  for (int i = 1; i < count; ++i) more += "," + text.substr(begin, end - begin);
  return std::string(text).insert(end, more);
}

TEST(GltfCompression, PrimitivesOfOneDracoBlockCountEach) {
  std::vector<std::string> notes;
  GltfModel loaded = load_gltf_model(
      write_file("sample.gltf", with_primitives(with_draco(encode_draco(false)), 2)), notes);
  ASSERT_EQ(loaded.model.meshes.at(0).primitives.size(), 2u);
  const auto decompress = [&](const DracoLimits& limits) {
    return [&, limits] { decompress_draco(JsonCursor(loaded.document), loaded.model, limits); };
  };
  // Each has three vertices of 24 bytes.
  decompress({6, 2, 144})();
  using testing::ThrowsMessage;
  EXPECT_THAT(decompress({5, 2, 144}), ThrowsMessage<SceneError>(HasSubstr("too many vertices")));
  EXPECT_THAT(decompress({6, 1, 144}), ThrowsMessage<SceneError>(HasSubstr("too many triangles")));
  EXPECT_THAT(decompress({6, 2, 143}), ThrowsMessage<SceneError>(HasSubstr("too many bytes")));
}

TEST(GltfCompression, DracoBlocksAreCountedAsOftenAsTheyAreNamed) {
  const std::string text = with_draco(std::string(std::size_t{1} << 20, '\0'));
  EXPECT_THAT(refusal_of(with_primitives(text, 513)),
              HasSubstr("primitives[512].extensions.KHR_draco_mesh_compression.bufferView: the "
                        "compressed blocks of all primitives are larger than 512 MiB"));
}

// Damaged data are read or refused; nothing crashes.
TEST(GltfCompression, DamagedDataAreReadOrRefused) {
  const Meshopt meshopt = encode_meshopt();
  const std::string draco = encode_draco(true);
  std::mt19937 random(3);
  int refused = 0;
  constexpr int kRounds = 300;
  for (int round = 0; round < kRounds; ++round) {
    Meshopt wrong = meshopt;
    std::string other = draco;
    for (std::string* data : {&wrong.vertices, &wrong.indices, &other}) {
      for (std::size_t k = random() % 3; k > 0; --k) {
        (*data)[random() % data->size()] = static_cast<char>(random());
      }
      if (random() % 8 == 0) data->resize(1 + random() % data->size());
    }
    refused += refusal_of(with_meshopt(wrong)) != "accepted";
    refused += refusal_of(with_draco(other)) != "accepted";
  }
  EXPECT_GT(refused, kRounds / 4);
  EXPECT_LT(refused, 2 * kRounds);
}

std::string textured(const std::string& image, const std::string& texture) {
  const std::string with_image =
      replaced(sample_gltf(), R"("scene": 0)",
               R"("scene": 0, "images": [)" + image + R"(], "textures": [)" + texture + "]");
  return replaced(with_image, R"("metallicFactor": 0)",
                  R"("metallicFactor": 0, "baseColorTexture": {"index": 0})");
}

std::string encode_webp() {
  const std::vector<std::uint8_t> pixels{10, 20, 30, 255, 200, 100, 50, 128};
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(pixels.data(), 2, 1, 8, &encoded);
  std::string bytes(reinterpret_cast<char*>(encoded), size);
  WebPFree(encoded);
  return bytes;
}

TEST(GltfCompression, WebpTexturesAreRead) {
  const std::string image = R"({"uri": ")" + data_uri(encode_webp(), "image/webp") + "\"}";
  const Scene scene =
      load_text(textured(image, R"({"extensions": {"EXT_texture_webp": {"source": 0}}})"));
  ASSERT_EQ(scene.textures.size(), 1u);
  ASSERT_EQ(scene.textures[0].texels.size(), glm::ivec2(2, 1));
  EXPECT_EQ(scene.textures[0].texels.at(0, 0), common::Rgba8(10, 20, 30, 255));
  EXPECT_EQ(scene.textures[0].texels.at(1, 0), common::Rgba8(200, 100, 50, 128));
}

TEST(GltfCompression, DamagedWebpIsRefused) {
  const std::string whole = encode_webp();
  for (std::size_t size = 13; size + 2 < whole.size(); ++size) {
    const std::string image =
        R"({"uri": ")" + data_uri(whole.substr(0, size), "image/webp") + "\"}";
    EXPECT_NE(refusal_of(textured(image, R"({"source": 0})")), "accepted") << size;
  }
}

TEST(GltfCompression, BasisTexturesFallBackToAnOrdinaryPicture) {
  const std::string images = R"({"uri": ")" + data_uri(encode_webp()) + R"("}, {"uri": "t.ktx2"})";
  const std::string basis = R"("extensions": {"KHR_texture_basisu": {"source": 1}})";
  EXPECT_EQ(load_text(textured(images, R"({"source": 0, )" + basis + "}")).textures.size(), 1u);
  EXPECT_THAT(refusal_of(textured(images, "{" + basis + "}")), HasSubstr("ktxdecompress"));
}

}  // namespace
}  // namespace amalgam::scene
