#include "support/reference/primitives.h"

#include <cmath>

namespace amalgam::reference {
namespace {

// Where a cone meets a plane under the cosine c, it covers a square of side width / |c|
// (Akenine-Moller et al., Ray Tracing Gems, 2019, ch. 20).
double covered_area(const Ray& ray, double t, const Vec3& plane_normal) {
  constexpr double kEdgeOn = 1e-4;
  const double cosine = std::abs(glm::dot(ray.direction, plane_normal));
  const double side = ray.width_at(t) / std::max(kEdgeOn, cosine);
  return side * side;
}

}  // namespace

void Box::include(const Vec3& point) {
  low = glm::min(low, point);
  high = glm::max(high, point);
}

void Box::include(const Box& box) {
  low = glm::min(low, box.low);
  high = glm::max(high, box.high);
}

Box bounds(const Triangle& triangle) {
  Box box;
  for (const Vec3& corner : triangle.corners) box.include(corner);
  return box;
}

Box bounds(const Ball& ball) {
  return {ball.centre - ball.radius, ball.centre + ball.radius};
}

// Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
std::optional<Hit> intersect(const Ray& ray, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  const Vec3 ab = b - a, ac = c - a;
  const Vec3 p = glm::cross(ray.direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0.0) return std::nullopt;
  const Vec3 from_a = ray.origin - a;
  const double v = glm::dot(from_a, p) / determinant;
  if (v < 0.0 || v > 1.0) return std::nullopt;
  const Vec3 q = glm::cross(from_a, ab);
  const double w = glm::dot(ray.direction, q) / determinant;
  if (w < 0.0 || v + w > 1.0) return std::nullopt;
  const double t = glm::dot(ac, q) / determinant;
  if (!(t >= ray.t_min && t <= ray.t_max)) return std::nullopt;

  const double u = 1.0 - v - w;
  Hit hit;
  hit.t = t;
  hit.position = ray.at(t);
  hit.geometric_normal = triangle.geometric_normal;
  const Vec3 normal = u * triangle.normals[0] + v * triangle.normals[1] + w * triangle.normals[2];
  const double length = glm::length(normal);
  hit.shading_normal = length > 0.0 ? normal / length : triangle.geometric_normal;
  hit.weights = {u, v, w};
  hit.covered_area = covered_area(ray, t, triangle.geometric_normal);
  hit.object = triangle.object;
  return hit;
}

std::optional<Hit> intersect(const Ray& ray, const Ball& ball) {
  const Vec3 from_centre = ray.origin - ball.centre;
  const double half_b = glm::dot(from_centre, ray.direction);
  // The squared distance of the centre from the ray, rather than b^2 - c, which cancels.
  const Vec3 nearest = from_centre - half_b * ray.direction;
  const double discriminant = ball.radius * ball.radius - glm::dot(nearest, nearest);
  if (discriminant < 0.0) return std::nullopt;
  const double half_chord = std::sqrt(discriminant);
  for (const double t : {-half_b - half_chord, -half_b + half_chord}) {
    if (!(t >= ray.t_min && t <= ray.t_max)) continue;
    Hit hit;
    hit.t = t;
    hit.position = ray.at(t);
    hit.geometric_normal = glm::normalize(hit.position - ball.centre);
    hit.shading_normal = hit.geometric_normal;
    hit.object = ball.object;
    return hit;
  }
  return std::nullopt;
}

}  // namespace amalgam::reference
