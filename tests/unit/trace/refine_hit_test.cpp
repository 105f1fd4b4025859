// Where a ray met a triangle, computed again on the ray's exact line (numerics B1, B11, B12).
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "trace/refine_hit.h"
#include "unit/trace/trace_shot.h"

namespace amalgam::trace {
namespace {

struct Triangle {
  glm::vec3 a, b, c;
};

// A scene of one triangle.
class RefineHit : public testing::Test {
 protected:
  void place(const Triangle& triangle, const glm::mat4& world_from_mesh = glm::mat4(1.0f)) {
    embree_.reset();
    scene_ = {};
    scene::Mesh mesh;
    mesh.positions = {triangle.a, triangle.b, triangle.c};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}};
    test_support::add_object(scene_, mesh, test_support::make_mirror(), scene::Role::Virtual,
                             world_from_mesh);
    embree_.emplace(scene_);
    embree_->place(anchor_all(scene_));
    const auto corner = [&](const glm::vec3& p) {
      return glm::dvec3(glm::dmat4(world_from_mesh) * glm::dvec4(p, 1.0));
    };
    a_ = corner(triangle.a);
    u_ = corner(triangle.b) - a_;
    v_ = corner(triangle.c) - a_;
  }

  Hit on_line(const glm::dvec3& start, const glm::dvec3& direction,
              const glm::dvec2& traced = {0.3, 0.3}, double t = 1.0) const {
    return refine_hit(*embree_, {0, 0, traced, t}, start, direction, Visible::Everything);
  }

  glm::dvec3 at(double u, double v) const { return a_ + u * u_ + v * v_; }
  glm::dvec3 at(const Hit& hit) const { return at(hit.barycentric.x, hit.barycentric.y); }

  // The hit lies on the plane by its making; here, on the line and at its t.
  void expect_on_line(const Hit& hit, const glm::dvec3& start, const glm::dvec3& d) const {
    const glm::dvec3 from_start = at(hit) - start;
    const double edges = glm::length(u_) + glm::length(v_);
    const double length2 = glm::dot(d, d);
    const double along = glm::dot(from_start, d) / length2;
    // The solution is off by units of the distance, magnified by flat angles and narrow triangles.
    const glm::dvec3 area = glm::cross(u_, v_);
    const double cosine = std::abs(glm::dot(glm::normalize(area), d)) / std::sqrt(glm::dot(d, d));
    const double narrow = glm::length(u_) * glm::length(v_) / glm::length(area);
    const double solved = (1e-14 + 1e-16 * narrow) * (along + glm::length(a_)) / cosine;
    EXPECT_LE(glm::length(from_start - along * d), 1e-15 * edges + solved);
    EXPECT_LE(std::abs(hit.t - along), 1e-15 * (std::abs(along) + edges) + solved);
  }

  scene::Scene scene_;
  std::optional<EmbreeScene> embree_;
  glm::dvec3 a_{0.0}, u_{0.0}, v_{0.0};
};

// Triangles of all shapes met from near and far, on lines that Embree's own t and barycentric
// coordinates are off from.
TEST_F(RefineHit, LiesOnTheLineAndInTheTriangle) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f), share(0.05f, 0.45f);
  const auto vector = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  int compared = 0;
  for (const float distance : {0.1f, 10.0f, 1e3f, 1e5f}) {
    for (int i = 0; i < 500; ++i) {
      place({vector(), vector(), vector()});
      const float u = share(random), v = share(random);
      const glm::dvec3 direction = glm::normalize(glm::dvec3(vector()));
      const glm::dvec3 start = at(u, v) - double{distance} * direction;
      const glm::dvec3 normal = glm::normalize(glm::cross(u_, v_));
      if (std::abs(glm::dot(normal, direction)) < 0.01) continue;
      ++compared;
      const Hit hit = on_line(start, direction);
      expect_on_line(hit, start, direction);
      EXPECT_NEAR(hit.barycentric.x, u, 1e-6);
      EXPECT_NEAR(hit.barycentric.y, v, 1e-6);
    }
  }
  EXPECT_GT(compared, 1900);
}

// A needle a metre long and a micrometre wide (embree #387: wrong t on skinny triangles).
TEST_F(RefineHit, HoldsOnSkinnyTriangles) {
  for (const float width : {1e-2f, 1e-4f, 1e-6f}) {
    place({{0, 0, 0}, {1, 0, 0}, {0.5f, width, 0}});
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.1, 0.2, -1.0));
    for (const double u : {0.1, 0.4, 0.8}) {
      const glm::dvec3 start = at(u, 0.15) - 3.0 * direction;
      const Hit hit = on_line(start, direction);
      EXPECT_NEAR(hit.barycentric.x, u, 1e-8) << width;
      EXPECT_NEAR(hit.barycentric.y, 0.15, 1e-8) << width;
      EXPECT_NEAR(hit.t, 3.0, 1e-14) << width;
      expect_on_line(hit, start, direction);
    }
  }
}

TEST_F(RefineHit, FollowsTheInstance) {
  glm::mat4 world_from_mesh(1.0f);
  world_from_mesh[0] = {0.0f, 0.0f, -2.0f, 0.0f};
  world_from_mesh[1] = {0.0f, 0.5f, 0.0f, 0.0f};
  world_from_mesh[2] = {-1.0f, 0.0f, 0.0f, 0.0f};
  world_from_mesh[3] = {100.0f, -7.0f, 3.0f, 1.0f};
  place({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, world_from_mesh);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(-1.0, 0.1, 0.2));
  const glm::dvec3 start = at(0.2, 0.5) - 5.0 * direction;
  const Hit hit = on_line(start, direction);
  expect_on_line(hit, start, direction);
  EXPECT_NEAR(hit.barycentric.x, 0.2, 1e-12);
  EXPECT_NEAR(hit.barycentric.y, 0.5, 1e-12);
}

// The ray that was traced starts a little off the line and may meet a triangle that the line
// misses: up to a hundredth of the triangle beside it, its nearest edge counts.
TEST_F(RefineHit, LittleBesideTheTriangleTakesItsEdge) {
  place({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const glm::dvec3 down(0, 0, -1);
  const Hit left = on_line({-0.005, 0.5, 2.0}, down);
  EXPECT_EQ(left.barycentric, glm::dvec2(0.0, 0.5));
  EXPECT_EQ(left.t, 2.0);
  const Hit corner = on_line({-0.009, -0.009, 2.0}, down);
  EXPECT_EQ(corner.barycentric, glm::dvec2(0.0));
  const Hit slope = on_line({0.504, 0.504, 2.0}, down);
  EXPECT_NEAR(slope.barycentric.x, 0.5, 1e-15);
  EXPECT_NEAR(slope.barycentric.x + slope.barycentric.y, 1.0, 1e-15);
}

// Where another triangle is beside it, the line is in that one.
TEST_F(RefineHit, PassesIntoTheNeighbour) {
  place({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  scene_.meshes[0].positions.emplace_back(1, 1, 0);
  scene_.meshes[0].normals.emplace_back(0, 0, 1);
  scene_.meshes[0].triangles.emplace_back(1, 3, 2);
  embree_.emplace(scene_);
  embree_->place(anchor_all(scene_));
  const Hit hit = on_line({0.5001, 0.501, 2.0}, {0, 0, -1});
  EXPECT_EQ(hit.triangle, 1u);
  // From (1, 0) to (1, 1) and to (0, 1).
  EXPECT_NEAR(hit.barycentric.x, 0.5001 + 0.501 - 1.0, 1e-12);
  EXPECT_NEAR(hit.barycentric.y, 1.0 - 0.5001, 1e-12);
  EXPECT_NEAR(hit.t, 2.0, 1e-12);
}

// Two small triangles meet in a corner, at a distance from the origin at which rays are offset by
// more than a thousandth of the way. The line meets the flat one just before the corner; the traced
// ray, a little beside it, passed that and met the steep one.
TEST_F(RefineHit, FindsTheTriangleBeforeACorner) {
  constexpr float kSide = 1e-3f;
  const glm::vec3 corner(0.1f);
  place({corner, corner + glm::vec3(0, kSide, 0), corner + glm::vec3(-kSide, 0, kSide)});
  scene_.meshes[0].positions.push_back(corner + glm::vec3(kSide, 0, 0));
  scene_.meshes[0].normals.emplace_back(0, 0, 1);
  scene_.meshes[0].triangles.emplace_back(0, 3, 1);
  embree_.emplace(scene_);
  embree_->place(anchor_all(scene_));
  const glm::dvec3 met = glm::dvec3(corner) + glm::dvec3(2e-6, 0.3 * double{kSide}, 0.0);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(-1.0, 0.0, -0.3));
  const Hit hit = on_line(met - 3e-4 * direction, direction, {0.3, 0.001}, 3e-4);
  EXPECT_EQ(hit.triangle, 1u);
  EXPECT_NEAR(hit.t, 3e-4, 1e-9);
  EXPECT_NEAR(hit.barycentric.x, 2e-6 / double{kSide}, 1e-4);
}

// Otherwise what was traced stays, to the bit: the line misses, is parallel to the plane, lies in
// it, or would meet it behind its start.
TEST_F(RefineHit, KeepsTheTracedHitWhereTheLineHasNone) {
  place({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const glm::dvec2 traced(0.125, 0.25);
  const std::pair<glm::dvec3, glm::dvec3> lines[] = {
      {{-0.02, 0.5, 2.0}, {0, 0, -1}},  // beside
      {{0.6, 0.6, 2.0}, {0, 0, -1}},    // beyond the third edge
      {{-1.0, 0.2, 0.1}, {1, 0, 0}},    // parallel
      {{-1.0, 0.2, 0.0}, {1, 0, 0}},    // in the plane
      {{0.2, 0.2, -1.0}, {0, 0, -1}},   // behind
      {{0.2, 0.2, 0.0}, {0, 0, -1}},    // starts on it
  };
  for (const auto& [start, direction] : lines) {
    const Hit hit = on_line(start, direction, traced, 0.5);
    EXPECT_EQ(hit.barycentric, traced) << start.x << " " << start.z;
    EXPECT_EQ(hit.t, 0.5) << start.x << " " << start.z;
  }
}

// Corners on one line, or in one point, leave nothing to divide by.
TEST_F(RefineHit, KeepsTheTracedHitOfADegenerateTriangle) {
  const glm::vec3 p(0.3f, 0.2f, 0.1f);
  for (const Triangle& triangle : {Triangle{p, p, p}, {p, 2.0f * p, 4.0f * p}, {p, p, 2.0f * p}}) {
    place(triangle);
    for (const glm::vec3& direction : {glm::vec3(0, 0, -1), glm::normalize(p)}) {
      const Hit hit = on_line(p - direction, direction, {0.125, 0.25}, 0.5);
      EXPECT_TRUE(std::isfinite(hit.barycentric.x) && std::isfinite(hit.barycentric.y));
      EXPECT_GE(hit.barycentric.x, 0.0);
      EXPECT_GE(hit.barycentric.y, 0.0);
      EXPECT_LE(hit.barycentric.x + hit.barycentric.y, 1.0 + 1e-15);
      EXPECT_TRUE(std::isfinite(hit.t));
    }
  }
}

}  // namespace
}  // namespace amalgam::trace
