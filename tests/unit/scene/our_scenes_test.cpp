#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

#include "scene/features.h"
#include "scene/gltf/loader.h"
#include "scene/light/env_lights.h"

// The scenes of deploy/scenes are what the documents say they are.

namespace amalgam::scene {
namespace {

Scene load(const std::string& name) {
  return load_scene(std::string(AMALGAM_SOURCE_DIR "/deploy/scenes/") + name);
}

std::size_t triangles(const Scene& scene) {
  std::size_t sum = 0;
  for (const Instance& instance : scene.instances)
    sum += scene.meshes[instance.mesh].triangles.size();
  return sum;
}

const Instance& find(const Scene& scene, const std::string& node) {
  for (const Instance& instance : scene.instances) {
    if (instance.node == node) return instance;
  }
  throw std::runtime_error("no node " + node);
}

std::vector<glm::vec3> points(const Scene& scene, const Instance& instance) {
  std::vector<glm::vec3> placed;
  for (const glm::vec3& p : scene.meshes[instance.mesh].positions) {
    placed.emplace_back(instance.anchor_from_mesh * glm::dvec4(p, 1.0));
  }
  return placed;
}

glm::vec3 center(const std::vector<glm::vec3>& points) {
  glm::vec3 sum(0.0f);
  for (const glm::vec3& p : points) sum += p;
  return sum / static_cast<float>(points.size());
}

std::pair<float, float> extent(const std::vector<glm::vec3>& points, const glm::vec3& axis) {
  float low = 1e9f, high = -1e9f;
  for (const glm::vec3& p : points) {
    low = std::min(low, glm::dot(p, axis));
    high = std::max(high, glm::dot(p, axis));
  }
  return {low, high};
}

// A plane across one of the axes has a on one side and b on the other.
bool are_apart(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b,
               const std::vector<glm::vec3>& axes) {
  return std::any_of(axes.begin(), axes.end(), [&](const glm::vec3& axis) {
    const auto [a_low, a_high] = extent(a, axis);
    const auto [b_low, b_high] = extent(b, axis);
    return a_low > b_high || b_low > a_high;
  });
}

TEST(OurScenes, HaveNoLikelyMistakes) {
  for (const char* name : {"complex", "diffuse", "glassware", "markers", "mirror"}) {
    EXPECT_THAT(load(std::string(name) + ".gltf").warnings, testing::IsEmpty()) << name;
  }
}

TEST(OurScenes, ComplexIsTheThesissScene) {
  const Scene scene = load("complex.gltf");
  EXPECT_TRUE(scene.notes.empty()) << scene.notes.front();
  EXPECT_EQ(triangles(scene), 4006u);
  EXPECT_EQ(scene.world.marker, 40);
  EXPECT_EQ(scene.world.dictionary, "DICT_6X6_250");
  EXPECT_EQ(scene.world.marker_length, 0.05);
  ASSERT_TRUE(scene.environment);
  EXPECT_FALSE(scene.environment->low_dynamic_range);
  using Expected = std::tuple<Role, MaterialKind, std::size_t>;
  const std::map<std::string, Expected> expected{
      {"table", {Role::Real, MaterialKind::Diffuse, 2}},
      {"real mirror", {Role::Real, MaterialKind::Mirror, 12}},
      {"virtual mirror", {Role::Virtual, MaterialKind::Mirror, 12}},
      {"marble cube", {Role::Virtual, MaterialKind::Diffuse, 12}},
      {"mirror sphere", {Role::Virtual, MaterialKind::Mirror, 1984}},
      {"glass sphere", {Role::Virtual, MaterialKind::Dielectric, 1984}}};
  EXPECT_EQ(scene.instances.size(), expected.size());
  for (const auto& [node, what] : expected) {
    const Instance& instance = find(scene, node);
    const Expected actual{instance.role, scene.materials[instance.material].kind,
                          scene.meshes[instance.mesh].triangles.size()};
    EXPECT_EQ(actual, what) << node;
  }
  const Material& glass = scene.materials[find(scene, "glass sphere").material];
  EXPECT_EQ(glass.ior, 1.5f);
  EXPECT_FALSE(glass.thin);
  EXPECT_GT(glass.absorption.x, glass.absorption.y);
}

TEST(OurScenes, DiffuseAndMirrorScenesHaveOnlyThat) {
  const SceneFeatures diffuse = scene_features(load("diffuse.gltf")),
                      mirror = scene_features(load("mirror.gltf"));
  EXPECT_FALSE(diffuse.has_specular);
  EXPECT_TRUE(diffuse.has_virtual && diffuse.has_textures && diffuse.has_environment);
  EXPECT_TRUE(mirror.has_virtual_specular && mirror.has_real_diffuse);
  EXPECT_FALSE(mirror.has_transmissive || mirror.has_real_specular);
}

TEST(OurScenes, GlasswareIsMediaInMedia) {
  const Scene scene = load("glassware.gltf");
  EXPECT_TRUE(scene.notes.empty()) << scene.notes.front();
  const auto material = [&](const std::string& node) {
    return scene.materials[find(scene, node).material];
  };
  EXPECT_EQ(material("tumbler").ior, 1.5f);
  EXPECT_EQ(material("tea").ior, 1.33f);
  EXPECT_EQ(material("bubble").ior, 1.0f);
  EXPECT_TRUE(material("copper plate").normal_texture);
  EXPECT_GT(material("lamp").emission.x, 1.0f);
  // No surface of the tea lies in one of the glass: it reaches half way into it.
  const auto tea = points(scene, find(scene, "tea")), glass = points(scene, find(scene, "tumbler"));
  EXPECT_GT(extent(tea, {0, 1, 0}).first, extent(glass, {0, 1, 0}).first + 0.001f);
  EXPECT_LT(extent(tea, {1, 0, 0}).second, extent(glass, {1, 0, 0}).second - 0.001f);
}

TEST(OurScenes, MarkersHaveAnObjectEach) {
  const Scene scene = load("markers.gltf");
  EXPECT_FALSE(find(scene, "marble cube").marker);
  EXPECT_EQ(find(scene, "mirror sphere").marker, 62);
  EXPECT_EQ(find(scene, "blue cone").marker, 98);
}

TEST(OurScenes, ObjectsStandOnTheTable) {
  for (const char* name : {"complex.gltf", "diffuse.gltf", "mirror.gltf"}) {
    const Scene scene = load(name);
    for (const Instance& instance : scene.instances) {
      if (instance.node == "table") continue;
      const auto placed = points(scene, instance);
      const float bottom = extent(placed, {0, 1, 0}).first;
      EXPECT_GT(bottom, 0.0f) << name << ": " << instance.node;
      EXPECT_LT(bottom, 0.002f) << name << ": " << instance.node;
      float largest = 0.0f;
      for (int axis = 0; axis < 3; ++axis) {
        const auto& columns = instance.anchor_from_mesh;
        const auto [low, high] =
            extent(scene.meshes[instance.mesh].positions, glm::mat3(1.0f)[axis]);
        largest = std::max(largest, glm::length(glm::vec3(columns[axis])) * (high - low));
      }
      EXPECT_GE(largest, 0.04f) << name << ": " << instance.node;
      EXPECT_LE(largest, 0.165f) << name << ": " << instance.node;
    }
  }
}

TEST(OurScenes, ObjectsDoNotPierceEachOther) {
  for (const char* name : {"complex.gltf", "diffuse.gltf", "mirror.gltf"}) {
    const Scene scene = load(name);
    for (std::size_t i = 1; i < scene.instances.size(); ++i) {  // 0 is the table
      for (std::size_t j = i + 1; j < scene.instances.size(); ++j) {
        const Instance &first = scene.instances[i], &second = scene.instances[j];
        const auto a = points(scene, first), b = points(scene, second);
        std::vector<glm::vec3> axes{center(a) - center(b)};
        for (int column = 0; column < 3; ++column) {
          axes.emplace_back(first.anchor_from_mesh[column]);
          axes.emplace_back(second.anchor_from_mesh[column]);
        }
        EXPECT_TRUE(are_apart(a, b, axes)) << name << ": " << first.node << ", " << second.node;
      }
    }
  }
}

// Closed and outward: the signed volume of each object is positive.
TEST(OurScenes, FacesLookOutward) {
  for (const char* name :
       {"complex.gltf", "diffuse.gltf", "mirror.gltf", "glassware.gltf", "markers.gltf"}) {
    const Scene scene = load(name);
    for (const Instance& instance : scene.instances) {
      const Mesh& mesh = scene.meshes[instance.mesh];
      double volume = 0.0;
      for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        const glm::dvec3 mean(mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]);
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), mean), 0.0) << instance.node;
      }
      EXPECT_TRUE(volume > 0.0 || instance.node == "table") << instance.node;
    }
  }
}

TEST(OurScenes, TheSunThrowsShadowsToOneSide) {
  const Scene scene = load("complex.gltf");
  const auto lights = extract_lights(*scene.environment, {});
  const glm::vec3 sun = lights.front().to_light;
  EXPECT_LT(sun.x, -0.4f);  // from the left: shadows fall to the right
  EXPECT_GT(sun.y, 0.5f);
  float rest = 0.0f;
  for (std::size_t i = 1; i < lights.size(); ++i) rest += lights[i].intensity.y;
  EXPECT_GT(lights.front().intensity.y, rest);
  EXPECT_LT(lights.front().intensity.y, 3.0f * rest);
}

}  // namespace
}  // namespace amalgam::scene
