// Node transforms of a glTF file as matrices, and a check that they can be rendered with.
#pragma once

#include <glm/mat4x4.hpp>
#include <string>

#include "scene/gltf/model.h"

namespace amalgam::scene {

// The node's matrix, or translation x rotation x scale (rotation normalised).
glm::dmat4 parent_from_node(const tinygltf::Node& node);

// Largest over smallest singular value of the upper 3x3 part; infinity if singular or not finite.
double condition_number(const glm::dmat4& affine);

// Whether it makes everything flat or too small for any picture: a scale of 0 (valid glTF), or one
// as for atoms.
bool is_collapsed(const glm::dmat4& affine);

// Throws SceneError "path: ..." if an entry is not finite or beyond kMaxPlace.
void check_transform_finite(const glm::dmat4& affine, const std::string& path);

// Throws SceneError "path: ..." likewise, if the condition number is over 1e6 (numerics B23), or if
// float cannot hold the matrix, its determinant or its inverse.
void check_transform_usable(const glm::dmat4& affine, const std::string& path);

}  // namespace amalgam::scene
