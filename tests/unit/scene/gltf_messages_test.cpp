#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/scene/gltf_sample.h"

// What a file says about itself in refusals and notes: where it is wrong, in one line that is safe
// to print.

namespace amalgam::scene {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::string kLastAccessor = R"("type": "SCALAR"}])";

TEST(GltfMessages, SparseIndicesNameTheirAccessor) {
  // The last view read as 16-bit numbers from the second on: 1, 2.
  const Scene unread = load_text(
      replaced(sample_gltf(), kLastAccessor,
               R"("type": "SCALAR"}, {"componentType": 5126, "count": 2, "type": "SCALAR", "sparse":
         {"count": 2, "indices": {"bufferView": 3, "byteOffset": 2, "componentType": 5123},
         "values": {"bufferView": 0}}}])"));
  EXPECT_THAT(unread.notes,
              Contains("accessors[4].sparse: index 2 is beyond the accessor (not used)"));
  EXPECT_EQ(unread.instances.size(), 1u);
  // Read as one 32-bit number: 65536.
  EXPECT_THAT(refusal_of(replaced(sample_gltf(), R"({"bufferView": 0, "componentType": 5126,)",
                                  R"({"bufferView": 0, "componentType": 5126, "sparse":
         {"count": 1, "indices": {"bufferView": 3, "componentType": 5125},
         "values": {"bufferView": 1}},)")),
              HasSubstr("accessors[0].sparse: index 65536 is beyond"));
}

TEST(GltfMessages, TextureTransformsNameTheirMaterial) {
  EXPECT_THAT(refusal_of(replaced(
                  replaced(sample_gltf(), R"("scene": 0)", R"("scene": 0, "textures": [{}])"),
                  R"("metallicFactor": 0)",
                  R"("metallicFactor": 0, "baseColorTexture": {"index": 0,
                     "extensions": {"KHR_texture_transform": {"offset": [1]}}})")),
              HasSubstr("material red: KHR_texture_transform.offset: expected 2 numbers"));
}

bool has_control_characters(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20; });
}

TEST(GltfMessages, AreOneLineWhateverTheFileQuotes) {
  const std::string refusal = refusal_of(replaced(
      sample_gltf(), R"("name": "red",)", R"("name": "red", "alphaMode": "a\nb\u001b[2J",)"));
  EXPECT_THAT(refusal, HasSubstr("'a b [2J' is none of OPAQUE"));
  const std::string missing =
      refusal_of(replaced(sample_gltf(), "data:application/octet-stream;base64,", "a%0Ab.bin#"));
  EXPECT_THAT(missing, HasSubstr("'a b.bin"));
  EXPECT_FALSE(has_control_characters(missing));
}

TEST(GltfMessages, NotesAndWarningsAndNamesAreOneLineEach) {
  std::string text = replaced(sample_gltf(), R"("name": "thing")", R"("name": "thing\r\nERROR")");
  text =
      replaced(text, R"("name": "red")", R"("name": "red\nhot", "occlusionTexture": {"index": 0})");
  text = replaced(text, R"("scene": 0)", R"("scene": 0, "textures": [{}])");
  text = replaced(text, R"({"nodes": [0]})",
                  R"({"nodes": [0], "extras": {"amalgam": {"dictionary": "A\nB"}}})");
  const Scene scene = load_text(text);
  EXPECT_EQ(scene.instances.at(0).node, "thing  ERROR");
  EXPECT_THAT(scene.notes, Contains(HasSubstr("material red hot: occlusion")));
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("the dictionary 'A B' is none")));
  for (const auto* texts : {&scene.notes, &scene.warnings}) {
    for (const std::string& one : *texts) EXPECT_FALSE(has_control_characters(one)) << one;
  }
}

}  // namespace
}  // namespace amalgam::scene
