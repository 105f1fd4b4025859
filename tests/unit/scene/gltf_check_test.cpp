#include "scene/gltf/check/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/scene/gltf_sample.h"

namespace amalgam::scene {
namespace {

using testing::HasSubstr;

struct Breach {
  std::string from, to;  // in the sample
  std::string says;      // part of the message
};

class GltfCheck : public testing::TestWithParam<Breach> {};

TEST_P(GltfCheck, IsRefusedByName) {
  const Breach& breach = GetParam();
  EXPECT_THAT(refusal_of(replaced(sample_gltf(), breach.from, breach.to)), HasSubstr(breach.says));
}

const std::string kNode = R"({"name": "thing", "mesh": 0})";

INSTANTIATE_TEST_SUITE_P(
    Buffers, GltfCheck,
    testing::Values(
        Breach{R"("buffer": 0, "byteOffset": 0, "byteLength": 36)",
               R"("buffer": 1, "byteLength": 36)", "there is no buffers[1]"},
        Breach{R"("byteOffset": 96, "byteLength": 8)", R"("byteOffset": 96, "byteLength": 9)",
               "bufferViews[3]: reaches beyond its buffer"},
        Breach{R"("byteOffset": 96, "byteLength": 8)",
               R"("byteOffset": 9007199254740991, "byteLength": 8)",
               "bufferViews[3]: reaches beyond"},
        Breach{R"("byteLength": 104)", R"("byteLength": 1e300)", "buffers[0].byteLength"},
        Breach{R"("byteLength": 104)", R"("byteLength": 105)", "holds 104 bytes"},
        Breach{R"("byteLength": 104)", R"("byteLength": -1)", "buffers[0].byteLength"},
        Breach{R"("byteOffset": 0, "byteLength": 36)",
               R"("byteOffset": 0, "byteLength": 36, "byteStride": 8)", "byteStride"},
        Breach{"octet-stream;base64,A", "octet-stream;base64,*", "base64"},
        Breach{"octet-stream;base64,", "octet-stream,", "not base64"},
        Breach{R"("uri": "data:application/octet-stream;base64,)", R"("uri": "http://host/)",
               "has a scheme"}));

INSTANTIATE_TEST_SUITE_P(
    Accessors, GltfCheck,
    testing::Values(
        Breach{R"("count": 3, "type": "VEC2")", R"("count": 4, "type": "VEC2")",
               "accessors[2]: reaches beyond"},
        Breach{R"("count": 3, "type": "VEC2")", R"("count": 1e300, "type": "VEC2")",
               "accessors[2].count"},
        Breach{R"("count": 3, "type": "VEC2")", R"("count": 0, "type": "VEC2")", "another count"},
        Breach{R"("count": 3, "type": "VEC2")", R"("count": 2, "type": "VEC2")", "another count"},
        Breach{R"({"bufferView": 0, "componentType": 5126, "count": 3)",
               R"({"bufferView": 0, "componentType": 5126, "count": 2)", "another count"},
        Breach{R"({"bufferView": 1, "componentType": 5126, "count": 3)",
               R"({"bufferView": 1, "componentType": 5126, "count": 2)", "another count"},
        Breach{R"("type": "VEC2")", R"("type": "VEC7")", "VEC7"},
        Breach{R"("componentType": 5123)", R"("componentType": 5124)", "component type"},
        Breach{R"("componentType": 5123)", R"("componentType": 5122)", "not unsigned integers"},
        Breach{R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min")",
               R"({"componentType": 5126, "count": 2000000, "type": "VEC3", "min")", "no data"},
        Breach{
            R"("bufferView": 3)",
            R"("bufferView": 3, "sparse": {"count": 9, "indices": {"bufferView": 3, "componentType": 5123},
                  "values": {"bufferView": 3}})",
            "more sparse elements"},
        Breach{
            R"("bufferView": 2)",
            R"("bufferView": 2, "sparse": {"count": 3, "indices": {"bufferView": 3, "componentType": 5123},
                  "values": {"bufferView": 3}})",
            "sparse data reach beyond"}));

INSTANTIATE_TEST_SUITE_P(
    Meshes, GltfCheck,
    testing::Values(Breach{R"("POSITION": 0)", R"("POSITION": 9)", "there is no accessors[9]"},
                    Breach{R"("POSITION": 0)", R"("POSITION": 2)", "format"},
                    Breach{R"("material": 0)", R"("material": 3)", "there is no materials[3]"},
                    Breach{R"("name": "red",)",
                           R"("extensions": {"KHR_materials_ior": {"ior": 0.5}},)", "is below 1"},
                    Breach{R"("metallicFactor": 0)", R"("metallicFactor": 1.1)", "not within"},
                    Breach{R"([1, 0, 0, 1])", R"([1, 0, 0, 1.5])", "not within"},
                    Breach{R"([1, 0, 0, 1])", R"([1, 0, 0])", "expected 4 numbers"},
                    Breach{R"("indices": 3)", R"("indices": 3, "mode": 7)", "mode"},
                    Breach{R"("indices": 3)", R"("indices": -1)", "indices"},
                    Breach{R"("indices": 3)", R"("indices": "3")", "expected a number"},
                    Breach{R"([{"attributes")", R"({"attributes")", "JSON"}));

INSTANTIATE_TEST_SUITE_P(
    Nodes, GltfCheck,
    testing::Values(
        Breach{kNode, R"({"children": [0]})", "its own ancestor"},
        Breach{kNode, R"({"children": [1]}, {"children": [2]}, {"children": [1]})", "two parents"},
        Breach{kNode, R"({"mesh": 0}, {"children": [2]}, {"children": [1]})", "its own ancestor"},
        Breach{kNode, R"({"mesh": 4})", "there is no meshes[4]"},
        Breach{kNode, R"({"mesh": 0, "scale": [1, 1]})", "expected 3 numbers"},
        Breach{kNode, R"({"mesh": 0, "scale": [1, 1, 1e-7]})", "singular"},
        Breach{kNode, R"({"mesh": 0, "scale": [1e300, 1e300, 1e300]})", "too large"},
        Breach{kNode, R"({"mesh": 0, "rotation": [0, 0, 0, 2]})", "unit quaternion"},
        Breach{kNode, R"({"mesh": 0, "translation": [1, 2, 1e999]})", "JSON"},
        Breach{kNode, R"({"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0.1, 0,0,0,1]})",
               "last row"},
        Breach{R"({"nodes": [0]})", R"({"nodes": [7]})", "there is no nodes[7]"},
        Breach{R"("scene": 0)", R"("scene": 2)", "there is no scenes[2]"}));

INSTANTIATE_TEST_SUITE_P(
    Document, GltfCheck,
    testing::Values(Breach{R"("version": "2.0")", R"("version": "1.0")", "1.0"},
                    Breach{R"("version": "2.0")", R"("version": "two")", "two"},
                    Breach{R"("version": "2.0")", R"("version": 2)", "expected a string"},
                    Breach{R"("asset": {"version": "2.0"},)", "", "has no 'asset'"},
                    Breach{R"("scene": 0)", R"("extensionsUsed": ["EXT_mesh_gpu_instancing"],
                           "extensionsRequired": ["EXT_mesh_gpu_instancing"])",
                           "EXT_mesh_gpu_instancing, which is not supported"},
                    Breach{R"("scene": 0)",
                           R"("images": [{"uri": "t.ktx2"}], "textures":
                           [{"extensions": {"KHR_texture_basisu": {"source": 0}}}])",
                           "npx @gltf-transform/cli ktxdecompress"},
                    Breach{R"("scene": 0)", R"("scene": 0, "scene": 0)", "occurs twice"},
                    Breach{R"("scene": 0)",
                           R"("images": [{"uri": "missing.png"}], "textures": [{"source": 0}])",
                           "images[0].uri: 'missing.png': No such file"},
                    Breach{R"("scene": 0)",
                           R"("scene": 0, "images": [{"uri": "data:image/png;base64,AAAA"}],
                           "textures": [{"source": 1}])",
                           "there is no images[1]"}));

TEST(GltfCheck, DepthIsBoundedBeforeAnythingRecurses) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "[";
  EXPECT_THAT(refusal_of(deep), HasSubstr("nested"));
  EXPECT_THAT(refusal_of(replaced(sample_gltf(), R"("scene": 0)", R"("extras": )" + deep)),
              HasSubstr("nested"));
}

TEST(GltfCheck, LongChainsOfNodesAreRefusedOrRead) {
  const auto chain = [](int length) {
    std::string nodes;
    for (int i = 0; i < length; ++i) nodes += R"({"children": [)" + std::to_string(i + 1) + "]}, ";
    return replaced(sample_gltf(), kNode, nodes + kNode);
  };
  EXPECT_EQ(refusal_of(chain(900)), "accepted");
  EXPECT_THAT(refusal_of(chain(20000)), HasSubstr("nested more than 1000"));
}

TEST(GltfCheck, IndicesBeyondTheVerticesAreRefused) {
  // The last view read as one 32-bit index: 0x00010000 and 2.
  const std::string text = replaced(sample_gltf(), R"("componentType": 5123, "count": 3)",
                                    R"("componentType": 5125, "count": 2)");
  EXPECT_THAT(refusal_of(text), HasSubstr("65536, but there are 3 vertices"));
}

TEST(GltfCheck, EmptyViewsAreNotedUnlessSomethingReadsThem) {
  const std::string unread =
      replaced(sample_gltf(), R"("byteOffset": 96, "byteLength": 8})",
               R"("byteOffset": 96, "byteLength": 8}, {"buffer": 0, "byteLength": 0})");
  EXPECT_THAT(load_text(unread).notes, testing::Contains(HasSubstr("bufferViews[4]: is empty")));
  EXPECT_THAT(refusal_of(replaced(unread, R"("bufferView": 3)", R"("bufferView": 4)")),
              HasSubstr("reaches beyond"));
  EXPECT_THAT(
      refusal_of(replaced(unread, R"("scene": 0)",
                          R"("scene": 0, "images": [{"bufferView": 4, "mimeType": "image/png"}])")),
      HasSubstr("images[0].bufferView: an empty view"));
}

}  // namespace
}  // namespace amalgam::scene
