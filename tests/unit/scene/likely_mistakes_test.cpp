#include "scene/likely_mistakes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/closed_mesh.h"
#include "scene/glass_winding.h"
#include "unit/scene/gltf_sample.h"

namespace amalgam::scene {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

// A cube of side 2 around a place, with flat normals outward.
Mesh cube(const glm::vec3& center = glm::vec3(0.0f)) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 n(0.0f), u(0.0f), v(0.0f);
      n[axis] = side;
      u[(axis + 1) % 3] = 1.0f;
      v[(axis + 2) % 3] = side;  // cross(u, v) = n
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const glm::vec2& p : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        mesh.positions.push_back(center + n + p.x * u + p.y * v);
        mesh.normals.push_back(n);
      }
      mesh.triangles.emplace_back(first, first + 1, first + 2);
      mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
  }
  return mesh;
}

Scene glass_scene(std::vector<Mesh> meshes) {
  Scene scene;
  scene.materials.emplace_back();
  scene.materials[0].name = "glass";
  scene.materials[0].kind = MaterialKind::Dielectric;
  scene.materials[0].thin = false;
  for (Mesh& mesh : meshes) {
    Instance instance;
    instance.node = "body" + std::to_string(scene.meshes.size());
    instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
    scene.instances.push_back(instance);
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

TEST(ClosedMesh, MeasuresOfACube) {
  Mesh mesh = cube({5, 6, 7});
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(signed_volume(mesh), 8.0, 1e-12);
  EXPECT_NEAR(normals_along_winding(mesh), 24.0, 1e-12);
  EXPECT_NEAR(winding_number(mesh, {5.5, 6.9, 6.2}), 1.0, 1e-12);
  EXPECT_NEAR(winding_number(mesh, {5.5, 7.1, 6.2}), 0.0, 1e-12);
  flip_winding(mesh);
  EXPECT_NEAR(signed_volume(mesh), -8.0, 1e-12);
  EXPECT_NEAR(winding_number(mesh, {5, 6, 7}), -1.0, 1e-12);
  mesh.triangles.pop_back();
  EXPECT_FALSE(is_closed(mesh));
}

TEST(ClosedMesh, ATurnedTriangleOpensIt) {
  Mesh mesh = cube();
  std::swap(mesh.triangles[3].x, mesh.triangles[3].y);
  EXPECT_FALSE(is_closed(mesh));
}

TEST(GlassWinding, InwardGlassIsTurned) {
  for (const bool winding : {false, true}) {
    for (const bool normals : {false, true}) {
      Mesh mesh = cube();
      if (winding) flip_winding(mesh);
      if (normals) flip_normals(mesh);
      Scene scene = glass_scene({mesh});
      turn_glass_outward(scene);
      EXPECT_EQ(scene.meshes[0].normals, cube().normals);
      EXPECT_GT(signed_volume(scene.meshes[0]), 0.0);
      EXPECT_EQ(scene.warnings.size(), (winding ? 1u : 0u) + (normals ? 1u : 0u));
    }
  }
}

// A hollow's wall faces the air inside it; a room faces its inside; neither is a mistake.
TEST(GlassWinding, HollowsAndOtherMaterialsStay) {
  Mesh inner = cube();
  for (glm::vec3& p : inner.positions) p *= 0.5f;
  flip_winding(inner);
  flip_normals(inner);
  Scene hollow = glass_scene({cube(), inner});
  turn_glass_outward(hollow);
  EXPECT_LT(signed_volume(hollow.meshes[1]), 0.0);
  EXPECT_TRUE(hollow.warnings.empty());
  Scene room = glass_scene({inner});
  room.materials[0].kind = MaterialKind::Diffuse;
  turn_glass_outward(room);
  EXPECT_LT(signed_volume(room.meshes[0]), 0.0);
}

// Comparing each with each would not end.
TEST(GlassWinding, VeryManyBodiesAreLeftAsTheyAre) {
  Mesh mesh = cube();
  flip_winding(mesh);
  Scene scene = glass_scene({mesh});
  const Instance first = scene.instances[0];
  scene.instances.assign(10'001, first);
  turn_glass_outward(scene);
  EXPECT_THAT(scene.notes, Contains(HasSubstr("more than 10,000 bodies of glass")));
  EXPECT_LT(signed_volume(scene.meshes[0]), 0.0);
  // What is not solid glass does not count.
  scene.notes.clear();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].kind = MaterialKind::Diffuse;
  scene.meshes.push_back(cube());
  for (std::size_t i = 1; i < scene.instances.size(); ++i) {
    scene.instances[i].material = scene.instances[i].mesh = 1;
  }
  turn_glass_outward(scene);
  EXPECT_TRUE(scene.notes.empty());
  EXPECT_GT(signed_volume(scene.meshes[0]), 0.0);
}

TEST(GlassWinding, WhatAnotherMaterialWearsTooStays) {
  Mesh mesh = cube();
  flip_winding(mesh);
  Scene scene = glass_scene({mesh});
  scene.materials.emplace_back();
  scene.instances.push_back(scene.instances[0]);
  scene.instances[1].material = 1;
  turn_glass_outward(scene);
  EXPECT_LT(signed_volume(scene.meshes[0]), 0.0);
}

// What lies on another marker may be anywhere: it is nobody's hollow.
TEST(GlassWinding, OnlyGlassOfTheSameMarkerHasHollows) {
  Mesh inner = cube();
  for (glm::vec3& p : inner.positions) p *= 0.5f;
  flip_winding(inner);
  Scene scene = glass_scene({cube(), inner});
  scene.instances[1].marker = 7;
  turn_glass_outward(scene);
  EXPECT_GT(signed_volume(scene.meshes[1]), 0.0);
}

TEST(LikelyMistakes, NoLight) {
  Scene scene;
  EXPECT_THAT(likely_mistakes(scene), Contains(HasSubstr("no light and no environment")));
  scene.punctual_lights.emplace_back().intensity = glm::vec3(1.0f);
  EXPECT_THAT(likely_mistakes(scene), testing::IsEmpty());
  scene.punctual_lights.clear();
  scene.environment.emplace().radiance = common::ImageRgb32f(2, 1, glm::vec3(0.0f));
  EXPECT_EQ(likely_mistakes(scene).size(), 1u);
  scene.environment->radiance.at(0, 0).y = 1.0f;
  EXPECT_THAT(likely_mistakes(scene), testing::IsEmpty());
}

TEST(LikelyMistakes, BodiesOfThinGlass) {
  Scene scene = glass_scene({cube()});
  EXPECT_THAT(likely_mistakes(scene), Not(Contains(HasSubstr("does not refract"))));
  scene.materials[0].thin = true;
  EXPECT_THAT(likely_mistakes(scene), Contains(HasSubstr("node body0: its material glass")));
  scene.instances.push_back(scene.instances[0]);
  scene.instances[1].node = "again";
  EXPECT_THAT(likely_mistakes(scene), Contains(HasSubstr("node again: its material glass")));
  for (glm::vec3& p : scene.meshes[0].positions) p.y *= 0.01f;  // a pane
  EXPECT_THAT(likely_mistakes(scene), Not(Contains(HasSubstr("does not refract"))));
}

TEST(LikelyMistakes, Markers) {
  Scene scene;
  const auto with = [&](const std::string& dictionary, int marker, double length) {
    scene.world = {marker, dictionary, length};
    return likely_mistakes(scene);
  };
  EXPECT_EQ(with("DICT_6X6_250", 249, 0.05).size(), 1u);  // no light
  EXPECT_THAT(with("DICT_6X6_250", 250, 0.05),
              Contains("DICT_6X6_250 has no marker 250, only 0 to 249"));
  EXPECT_THAT(with("DICT_APRILTAG_16h5", 30, 0.05), Contains(HasSubstr("only 0 to 29")));
  EXPECT_THAT(with("6X6_250", 3, 0.05), Contains(HasSubstr("DICT_6X6_250 is")));
  EXPECT_THAT(with("ARUCO", 3, 0.05), Contains("the dictionary 'ARUCO' is none of OpenCV's"));
  EXPECT_EQ(with("own.yml", 5000, 0.05).size(), 1u);
  EXPECT_THAT(with("DICT_6X6_250", 3, 50.0), Contains(HasSubstr("one of 50 m")));
}

TEST(LikelyMistakes, NodesAroundThePoint) {
  Scene scene = glass_scene({cube()});
  scene.instances[0].anchor_from_mesh[3] = glm::dvec4(10, 0, 0, 1);
  EXPECT_THAT(nodes_around(scene, 0, {10.5, 0.5, 0.5}), testing::ElementsAre("body0"));
  EXPECT_TRUE(nodes_around(scene, 0, {11.5, 0.5, 0.5}).empty());
  EXPECT_TRUE(nodes_around(scene, 1, {10.5, 0.5, 0.5}).empty());
}

TEST(LikelyMistakes, ExtrasThatAreNotRead) {
  const auto warnings = [](const std::string& extras) {
    return load_text(replaced(sample_gltf(), R"("name": "thing",)",
                              R"("name": "thing", "extras": )" + extras + ","))
        .warnings;
  };
  const std::string none = "no \"extras\"";
  EXPECT_THAT(warnings(R"({"amalgam": {"role": "real"}})"), Not(Contains(HasSubstr("extras"))));
  EXPECT_THAT(warnings(R"({"amalgam_role": "real"})"),
              Contains(HasSubstr("nodes[0].extras.amalgam_role: is not read")));
  EXPECT_THAT(warnings(R"({"Amalgam": {"role": "real"}})"), Contains(HasSubstr("extras.Amalgam")));
  EXPECT_THAT(warnings(R"({"role": "real"})"), Contains(HasSubstr("extras.role")));
  EXPECT_THAT(warnings(R"({"other": 1})"), Contains(HasSubstr(none)));
}

}  // namespace
}  // namespace amalgam::scene
