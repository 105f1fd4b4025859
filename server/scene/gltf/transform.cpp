#include "scene/gltf/transform.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "scene/gltf/check/limits.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

// One Jacobi rotation that makes m[p][q] of a symmetric matrix 0.
void rotate_away(glm::dmat3& m, int p, int q) {
  if (m[p][q] == 0.0) return;
  const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double c = 1.0 / std::hypot(t, 1.0), s = t * c;
  glm::dmat3 rotation(1.0);
  rotation[p][p] = rotation[q][q] = c;
  rotation[q][p] = s;
  rotation[p][q] = -s;
  m = glm::transpose(rotation) * m * rotation;
}

}  // namespace

glm::dmat4 parent_from_node(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) {
    glm::dmat4 matrix(1.0);
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) {
        matrix[column][row] = node.matrix[static_cast<std::size_t>(4 * column + row)];
      }
    }
    return matrix;
  }
  glm::dmat4 matrix(1.0);
  if (node.rotation.size() == 4) {
    const auto& q = node.rotation;
    matrix = glm::mat4_cast(glm::normalize(glm::dquat(q[3], q[0], q[1], q[2])));
  }
  if (node.scale.size() == 3) {
    for (int i = 0; i < 3; ++i) matrix[i] *= node.scale[static_cast<std::size_t>(i)];
  }
  if (node.translation.size() == 3) {
    matrix[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
  }
  return matrix;
}

double condition_number(const glm::dmat4& affine) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  glm::dmat3 linear(affine);
  double largest = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) largest = std::fmax(largest, std::abs(linear[i][j]));
  }
  if (!(largest > 0.0) || !std::isfinite(largest)) return kInfinity;
  linear /= largest;  // so that squares of tiny scales do not vanish

  // Singular values are the roots of the eigenvalues of A^T A.
  glm::dmat3 m = glm::transpose(linear) * linear;
  constexpr int kSweeps = 12;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rotate_away(m, 0, 1);
    rotate_away(m, 0, 2);
    rotate_away(m, 1, 2);
  }
  const double low = std::fmin(m[0][0], std::fmin(m[1][1], m[2][2]));
  const double high = std::fmax(m[0][0], std::fmax(m[1][1], m[2][2]));
  return low > 0.0 && std::isfinite(high) ? std::sqrt(high / low) : kInfinity;
}

bool is_collapsed(const glm::dmat4& affine) {
  constexpr double kFlat = 1e12;  // products of rotations and a scale of 0 leave rounding
  constexpr double kTiny = 1e-9;  // times a metre
  double largest = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!std::isfinite(affine[i][j])) return false;
      largest = std::fmax(largest, std::abs(affine[i][j]));
    }
  }
  return largest < kTiny || condition_number(affine) > kFlat;
}

void check_transform_finite(const glm::dmat4& affine, const std::string& path) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!(std::abs(affine[i][j]) <= kMaxPlace))
        throw SceneError(path + ": its transform is not finite or too large");
    }
  }
}

void check_transform_usable(const glm::dmat4& affine, const std::string& path) {
  constexpr double kMaxCondition = 1e6 * (1.0 + 1e-3);  // the computed one is good to 1e-4 there
  constexpr double kMinDeterminant = 1e-36, kMaxDeterminant = 1e36;  // Embree's is a normal float
  check_transform_finite(affine, path);
  const double determinant = std::abs(glm::determinant(glm::dmat3(affine)));
  if (!(condition_number(affine) <= kMaxCondition) || !(determinant >= kMinDeterminant)) {
    throw SceneError(path + ": its transform (with its parents') is singular or nearly so");
  }
  if (!(determinant <= kMaxDeterminant)) {
    throw SceneError(path + ": its transform (with its parents') is too large");
  }
}

}  // namespace amalgam::scene
