#include "scene/gltf/check/json_value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/gltf/container.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

std::string message_of(const auto& action) {
  try {
    action();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(JsonValue, ParsesEveryKind) {
  const JsonValue root = parse_json(R"({"a": [1, -2.5, true, null, "x\u00e9"], "b": {}})");
  const JsonCursor cursor(root);
  const auto items = cursor.get("a").items();
  ASSERT_EQ(items.size(), 5u);
  EXPECT_EQ(items[0].integer(0), 1);
  EXPECT_EQ(items[1].number(), -2.5);
  EXPECT_TRUE(items[2].boolean());
  EXPECT_EQ(items[3].value().kind, JsonValue::Kind::Null);
  EXPECT_EQ(items[4].string(), "x\xC3\xA9");
  EXPECT_TRUE(cursor.get("b").members().empty());
  EXPECT_FALSE(cursor.find("c"));
}

TEST(JsonValue, ErrorsCarryThePath) {
  const JsonValue root = parse_json(R"({"a": [{"b": 1.5}]})");
  const JsonCursor b = JsonCursor(root).get("a").items()[0].get("b");
  EXPECT_EQ(b.path(), "a[0].b");
  EXPECT_EQ(message_of([&] { b.string(); }), "a[0].b: expected a string, not a number");
  EXPECT_EQ(message_of([&] { b.integer(0); }), "a[0].b: expected an integer");
  EXPECT_EQ(message_of([&] { b.number(2, 3); }), "a[0].b: 1.5 is not within 2.0 and 3.0");
  EXPECT_EQ(message_of([&] { JsonCursor(root).get("z"); }), "has no 'z'");
}

TEST(JsonValue, BadTextIsRefused) {
  for (const char* text : {"", "{", "[1,]", "{\"a\":}", "nul", "[1] 2", "\xEF\xBB\xBF{}", "[1e999]",
                           R"({"a": 1, "a": 2})", "\"\xFF\""}) {
    EXPECT_THROW(parse_json(text), SceneError) << text;
  }
}

TEST(JsonValue, DepthIsBounded) {
  const auto nested = [](int depth) {
    const auto n = static_cast<std::size_t>(depth);
    return std::string(n, '[') + std::string(n, ']');
  };
  EXPECT_NO_THROW(parse_json(nested(kMaxJsonDepth)));
  EXPECT_THROW(parse_json(nested(kMaxJsonDepth + 1)), SceneError);
}

std::string u32(std::size_t n) {
  std::string s;
  for (int i = 0; i < 4; ++i) s += static_cast<char>(n >> (8 * i) & 255);
  return s;
}

struct Opened {
  GltfContainer container;
  std::vector<std::string> notes;
};

Opened open(const std::string& file, bool glb = true) {
  Opened opened;
  opened.container = open_gltf_container(std::as_bytes(std::span(file)), glb, opened.notes);
  return opened;
}

std::string text_of(const std::optional<std::span<const std::byte>>& bytes) {
  if (!bytes) return "nothing";
  return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

std::string glb_of(const std::string& chunks) {
  return "glTF" + u32(2) + u32(12 + chunks.size()) + chunks;
}

const std::string kJsonChunk = u32(4) + "JSON{}  ";
const std::string kBinChunk = u32(4) + std::string("BIN\0abcd", 8);

TEST(JsonValue, ListsTellTheirSizeAndFront) {
  const JsonValue root = parse_json(R"({"a": [7, "x"], "b": [], "c": {}})");
  const JsonCursor cursor(root);
  EXPECT_EQ(cursor.get("a").size(), 2u);
  EXPECT_EQ(cursor.get("a").front()->path(), "a[0]");
  EXPECT_EQ(cursor.get("a").front()->integer(0), 7);
  EXPECT_FALSE(cursor.get("b").front());
  EXPECT_EQ(message_of([&] { cursor.get("c").front(); }), "c: expected an array, not an object");
}

TEST(GltfContainer, ChunksAreFound) {
  const std::string file = glb_of(kJsonChunk + kBinChunk);
  const Opened glb = open(file, false);
  EXPECT_EQ(glb.container.json, "{}  ");
  EXPECT_EQ(text_of(glb.container.binary), "abcd");
  EXPECT_TRUE(glb.notes.empty());
  EXPECT_EQ(open("{}", false).container.json, "{}");
}

// Writers that do not pad their chunks, or do not count the padding.
TEST(GltfContainer, UnpaddedChunksAreFoundAndNoted) {
  for (const std::string padding : {"", " "}) {
    const std::string file =
        glb_of(u32(3) + "JSON{} " + padding + u32(3) + std::string("BIN\0abc", 7));
    const Opened glb = open(file);
    EXPECT_EQ(glb.container.json, "{} ");
    EXPECT_EQ(text_of(glb.container.binary), "abc");
    EXPECT_THAT(glb.notes, testing::Contains("GLB chunk length is not a multiple of 4"));
  }
}

TEST(GltfContainer, BytesBehindTheEndAreNoted) {
  const Opened glb = open(glb_of(kJsonChunk + kBinChunk) + "rubbish that is long");
  EXPECT_EQ(text_of(glb.container.binary), "abcd");
  EXPECT_THAT(glb.notes, testing::Contains(testing::HasSubstr("GLB declares 36 bytes and has 56")));
}

TEST(GltfContainer, ALengthThatLeavesOutTheLastChunkIsNoted) {
  std::string file = glb_of(kJsonChunk + kBinChunk);
  file.replace(8, 4, u32(24));
  const Opened glb = open(file);
  EXPECT_EQ(text_of(glb.container.binary), "abcd");
  EXPECT_EQ(glb.notes.size(), 1u);
}

TEST(GltfContainer, EveryTruncationIsRefused) {
  const std::string file = glb_of(kJsonChunk + kBinChunk);
  for (std::size_t size = 0; size < file.size(); ++size) {
    EXPECT_THROW(open(file.substr(0, size)), SceneError) << size;
  }
}

TEST(GltfContainer, ChunksOutOfPlaceAreRefused) {
  EXPECT_THROW(open(glb_of(kBinChunk)), SceneError);
  EXPECT_THROW(open(glb_of(kJsonChunk + kJsonChunk)), SceneError);
  EXPECT_THROW(open(glb_of(kJsonChunk + kBinChunk + kBinChunk)), SceneError);
  EXPECT_NO_THROW(open(glb_of(kJsonChunk + u32(0) + "XTRA")));
}

}  // namespace
}  // namespace amalgam::scene
