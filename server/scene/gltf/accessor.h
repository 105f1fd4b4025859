// Reads glTF accessors of any layout: strides, normalised integers, sparse values, no buffer view
// (zeros). check_gltf() has checked their extents in the buffers.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "scene/gltf/check/limits.h"
#include "scene/gltf/model.h"

namespace amalgam::scene {

// accessor.count elements of component_count(type) numbers each; integers are normalised if the
// accessor says so.
std::vector<float> read_floats(const tinygltf::Model& model, int accessor);

// The accessor must be a scalar of unsigned integers.
std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor);

std::vector<glm::vec3> read_vec3(const tinygltf::Model& model, int accessor);
std::vector<glm::vec4> read_vec4(const tinygltf::Model& model, int accessor);
std::vector<glm::vec2> read_vec2(const tinygltf::Model& model, int accessor);

// Throws for positions, texture coordinates or colors that are not finite, and for positions beyond
// kMaxPosition. Notes those outside the stated bounds by more than rounding: the bounds are not
// used. Normals and tangents are repaired later (numerics B21). Of what no attribute reads only
// max_unread numbers are looked at, for notes.
void check_accessor_data(const tinygltf::Model& model, std::vector<std::string>& notes,
                         std::size_t max_unread = kMaxUnreadNumbers);

}  // namespace amalgam::scene
