#include "scene/gltf/check/limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/gltf/accessor.h"
#include "scene/gltf/meshes.h"
#include "scene/gltf/resources.h"
#include "unit/scene/gltf_sample.h"

// Small files that ask for much. What would take gigabytes is tested by the counts that files
// state, or with smaller limits.

namespace amalgam::scene {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

const std::string kPrimitive =
    R"({"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3, "material": 0})";
const std::string kNode = R"({"name": "thing", "mesh": 0})";

std::string repeated(const std::string& element, int count) {
  std::string list = element;
  for (int i = 1; i < count; ++i) list += "," + element;
  return list;
}

// A mesh of equal primitives: accessor 0 for its vertices, 1 for its indices.
struct Sizes {
  std::size_t vertices, indices;
  int primitives = 1;
  int mode = TINYGLTF_MODE_TRIANGLES;
  bool has_normals = true;
};

std::string verdict_of(const Sizes& sizes) {
  tinygltf::Model model;
  model.accessors.resize(2);
  model.accessors[0].count = sizes.vertices;
  model.accessors[1].count = sizes.indices;
  tinygltf::Primitive primitive;
  primitive.attributes["POSITION"] = 0;
  if (sizes.has_normals) primitive.attributes["NORMAL"] = 0;
  primitive.indices = 1;
  primitive.mode = sizes.mode;
  model.meshes.emplace_back().primitives.assign(static_cast<std::size_t>(sizes.primitives),
                                                primitive);
  try {
    check_mesh_sizes(model);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(GltfLimits, VerticesOfAllPrimitivesAreCountedBeforeAnyIsRead) {
  EXPECT_EQ(verdict_of({1'000'000, 3, 50}), "accepted");
  EXPECT_EQ(verdict_of({1'000'000, 3, 51}),
            "meshes[0].primitives[50]: the meshes have more than 50 million vertices");
}

TEST(GltfLimits, TrianglesAreCounted) {
  EXPECT_EQ(verdict_of({3, 30'000'000, 5}), "accepted");
  EXPECT_THAT(verdict_of({3, 30'000'000, 6}), HasSubstr("primitives[5]: the meshes have more than "
                                                        "50 million triangles"));
  // A strip has one for each index.
  EXPECT_EQ(verdict_of({3, 30'000'000, 1, TINYGLTF_MODE_TRIANGLE_STRIP}), "accepted");
  EXPECT_THAT(verdict_of({3, 30'000'000, 2, TINYGLTF_MODE_TRIANGLE_STRIP}), HasSubstr("triangles"));
}

// Flat normals give every triangle vertices of its own; what is not drawn gets none.
TEST(GltfLimits, FlatTrianglesCountAllTheirCorners) {
  EXPECT_EQ(verdict_of({3, 48'000'000, 1, TINYGLTF_MODE_TRIANGLES, false}), "accepted");
  EXPECT_THAT(verdict_of({3, 51'000'000, 1, TINYGLTF_MODE_TRIANGLES, false}),
              HasSubstr("vertices"));
  EXPECT_EQ(verdict_of({3, 51'000'000, 1, TINYGLTF_MODE_POINTS, false}), "accepted");
}

TEST(GltfLimits, PrimitivesThatShareZerosAreRefused) {
  std::string text = replaced(sample_gltf(), "[" + kPrimitive + "]",
                              "[" + repeated(R"({"attributes": {"POSITION": 4}})", 51) + "]");
  text =
      replaced(text, R"("type": "SCALAR"}])",
               R"("type": "SCALAR"}, {"componentType": 5126, "count": 1000000, "type": "VEC3"}])");
  EXPECT_THAT(refusal_of(text), HasSubstr("more than 50 million vertices"));
}

TEST(GltfLimits, InstancesAreCounted) {
  std::string text =
      replaced(sample_gltf(), "[" + kPrimitive + "]", "[" + repeated(kPrimitive, 1001) + "]");
  text = replaced(text, kNode, repeated(R"({"mesh": 0})", 1000));
  EXPECT_THAT(refusal_of(text), HasSubstr("nodes[999]: the nodes draw more than a million"));
}

// The sample as its model, with three pictures of 36 bytes; that none is a picture is only noted.
class Pictures : public testing::Test {
 protected:
  Pictures() {
    const std::string image = R"({"bufferView": 0, "mimeType": "image/png"})";
    write_file("third.png", std::string(36, 'x'));
    path_ = write_file("sample.gltf", replaced(sample_gltf(), R"("scene": 0)",
                                               R"("scene": 0, "images": [)" + image + "," + image +
                                                   R"(, {"uri": "third.png"}])"));
    loaded_ = load_gltf_model(path_, notes_);
  }
  void read(std::size_t max_bytes) {
    const JsonCursor root(loaded_.document);
    const SceneFolder folder(path_);
    GltfResources(root, {}, folder, notes_).read_pictures(loaded_.model, max_bytes);
  }
  std::filesystem::path path_;
  std::vector<std::string> notes_;
  GltfModel loaded_;
};

TEST_F(Pictures, HaveALimitTogether) {
  EXPECT_NO_THROW(read(108));
  EXPECT_EQ(loaded_.model.images.at(2).image.size(), 36u);
  EXPECT_THAT([&] { read(107); }, ThrowsMessage<SceneError>(
                                      HasSubstr("images[2]: the pictures together are too large")));
  EXPECT_THAT([&] { read(71); }, ThrowsMessage<SceneError>(HasSubstr("images[1]")));
}

// A buffer takes what it declares, however long its file is.
TEST(GltfLimits, BuffersAreReadAsFarAsTheyAreDeclared) {
  const auto path = write_file("long.bin", std::string(10'000, 'x'));
  const SceneFolder folder(path);
  std::vector<std::string> notes;
  for (const char* uri : {R"(, "uri": "long.bin")", ""}) {
    const JsonValue document =
        parse_json(R"({"buffers": [{"byteLength": 100)" + std::string(uri) + "}]}");
    const JsonCursor root(document);
    const std::vector<std::byte> chunk(10'000);
    tinygltf::Model model;
    GltfResources(root, {"", chunk}, folder, notes).read_buffers(model);
    EXPECT_EQ(model.buffers.at(0).data.size(), 100u);
    EXPECT_LT(model.buffers.at(0).data.capacity(), 1000u);
  }
}

TEST(GltfLimits, OfUnreadNumbersSomeAreLookedAt) {
  const std::string unread = R"({"bufferView": 0, "componentType": 5126, "count": 3,
      "type": "VEC3", "min": [5, 5, 5], "max": [6, 6, 6]})";
  const auto path =
      write_file("sample.gltf", replaced(sample_gltf(), R"("type": "SCALAR"}])",
                                         R"("type": "SCALAR"}, )" + unread + ", " + unread + "]"));
  std::vector<std::string> other;
  const GltfModel loaded = load_gltf_model(path, other);
  const auto notes_of = [&](std::size_t numbers) {
    std::vector<std::string> notes;
    check_accessor_data(loaded.model, notes, numbers);
    return notes.size();
  };
  // The indices are three, and each of the two has nine.
  EXPECT_EQ(notes_of(21), 2u);
  EXPECT_EQ(notes_of(20), 1u);
  EXPECT_EQ(notes_of(11), 0u);
}

// The sample with its light or material made extreme.
Scene with_light(const std::string& light, const std::string& node = "") {
  return load_text(replaced(
      replaced(sample_gltf(), R"("scene": 0)", R"("scene": 0, "extensions": {"KHR_lights_punctual":
               {"lights": [)" + light + "]}}"),
      kNode, R"({"extensions": {"KHR_lights_punctual": {"light": 0}})" + node + "}"));
}

TEST(GltfLimits, LightStaysFinite) {
  for (const char* numbers : {R"("color": [1e30, 1, 0], "intensity": 1e30)",
                              R"("color": [1e308, 1e-20, 0], "intensity": 1e30)"}) {
    const Scene scene = with_light(R"({"type": "point", )" + std::string(numbers) + "}");
    EXPECT_EQ(scene.punctual_lights.at(0).intensity.x, 1e12f);
    EXPECT_EQ(scene.punctual_lights.at(0).intensity.z, 0.0f);
    EXPECT_THAT(scene.notes, Contains(HasSubstr("lights[0]: its color times intensity")));
  }
  const Scene bright = with_light(R"({"type": "point", "intensity": 1e12})");
  EXPECT_EQ(bright.punctual_lights.at(0).intensity, glm::vec3(1e12f));
  EXPECT_THAT(bright.notes, Not(Contains(HasSubstr("is brought to"))));
}

std::string with_material(const std::string& properties) {
  return replaced(sample_gltf(), R"("name": "red",)", R"("name": "red", )" + properties + ",");
}

TEST(GltfLimits, MaterialsStayFinite) {
  const Scene lamp = load_text(with_material(R"("emissiveFactor": [1e30, 1, 0], "extensions":
      {"KHR_materials_emissive_strength": {"emissiveStrength": 1e30}})"));
  EXPECT_EQ(lamp.materials[0].emission, glm::vec3(1e12f, 1e12f, 0.0f));
  EXPECT_THAT(lamp.notes, Contains("material red: its emission is brought to 1e12"));
  const Scene glass = load_text(with_material(R"("extensions": {
      "KHR_materials_transmission": {"transmissionFactor": 1},
      "KHR_materials_volume": {"thicknessFactor": 1, "attenuationColor": [0.5, 1, 0],
      "attenuationDistance": 1e-300}})"));
  EXPECT_EQ(glass.materials[0].absorption, glm::vec3(1e12f, 0.0f, 1e12f));
  EXPECT_THAT(glass.notes, Contains("material red: its absorption is brought to 1e12 a metre"));
  const std::string texture =
      replaced(with_material(R"("normalTexture": {"index": 0, "scale": 1e300})"), R"("scene": 0)",
               R"("scene": 0, "textures": [{}])");
  EXPECT_THAT(refusal_of(texture), HasSubstr("normalTexture.scale: 1e+300 is not within"));
  EXPECT_EQ(refusal_of(replaced(texture, "1e300", "-1e6")), "accepted");
}

TEST(GltfLimits, LightsFarAwayAreRefused) {
  const std::string light = R"({"type": "point"})";
  EXPECT_NO_THROW(with_light(light, R"(, "translation": [1e11, 0, 0])"));
  EXPECT_THAT([&] { with_light(light, R"(, "translation": [1e39, 0, 0])"); },
              ThrowsMessage<SceneError>(HasSubstr("nodes[0]: its transform is not finite")));
}

TEST(GltfLimits, LightsBelowInfiniteScalesAreRefused) {
  const std::string huge = R"("scale": [1e200, 1e200, 1e200])";
  EXPECT_THAT(
      refusal_of(replaced(replaced(sample_gltf(), R"("scene": 0)",
                                   R"("scene": 0, "extensions": {"KHR_lights_punctual": {"lights":
                              [{"type": "spot"}]}})"),
                          kNode,
                          R"({"children": [1], )" + huge + R"(}, {"extensions":
                         {"KHR_lights_punctual": {"light": 0}}, )" +
                              huge + "}")),
      HasSubstr("nodes[1]: its transform is not finite or too large"));
}

std::string with_positions(const std::vector<float>& numbers) {
  const std::string bytes(reinterpret_cast<const char*>(numbers.data()), 4 * numbers.size());
  std::string text =
      replaced(sample_gltf(), "\"}]}",
               R"("}, {"byteLength": 36, "uri": "data:application/octet-stream;base64,)" +
                   base64(bytes) + "\"}]}");
  return replaced(text, R"({"buffer": 0, "byteOffset": 0, "byteLength": 36})",
                  R"({"buffer": 1, "byteOffset": 0, "byteLength": 36})");
}

TEST(GltfLimits, VerticesBeyondTheReachOfRaysAreRefused) {
  EXPECT_EQ(refusal_of(with_positions({0, 0, 0, 1e12f, 0, 0, 0, 1, 0})), "accepted");
  EXPECT_THAT(refusal_of(with_positions({0, 0, 0, -2e12f, 0, 0, 0, 1, 0})),
              HasSubstr("accessors[0]: element 1 is farther than 1e12"));
}

}  // namespace
}  // namespace amalgam::scene
