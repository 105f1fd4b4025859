// Reads glTF accessors whatever their layout: strides, normalised integers, sparse values, none at
// all (zeros). Positions in buffers were checked by gltf_check.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "scene/gltf/model.h"

namespace amalgam::scene {

// Component-wise, accessor.count elements of component_count(type) numbers each, normalised if it
// says so.
std::vector<float> read_floats(const tinygltf::Model& model, int accessor);

// The accessor must be a scalar of unsigned integers.
std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor);

std::vector<glm::vec3> read_vec3(const tinygltf::Model& model, int accessor);
std::vector<glm::vec4> read_vec4(const tinygltf::Model& model, int accessor);
std::vector<glm::vec2> read_vec2(const tinygltf::Model& model, int accessor);

// Fails for an accessor with values that are not finite, or outside the bounds it states by more
// than rounding can explain. Normals and tangents are left out (not finite ones are repaired later:
// numerics B21).
void check_accessor_data(const tinygltf::Model& model);

}  // namespace amalgam::scene
