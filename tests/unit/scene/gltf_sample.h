// A small right glTF file as text, to be made wrong in one place by each test.
#pragma once

#include <filesystem>
#include <string>

#include "scene/gltf/loader.h"

namespace amalgam::scene {

// One node, one mesh, one triangle (0 0 0, 1 0 0, 0 1 0) with normals, texture coordinates and
// indices, one red material; one line an element, so that replacing is easy.
std::string sample_gltf();

// text with the first occurrence of from replaced; fails the test if there is none.
std::string replaced(std::string text, const std::string& from, const std::string& to);

// A folder of its own for each test.
std::filesystem::path test_folder();
std::filesystem::path write_file(const std::string& name, const std::string& contents);

Scene load_text(const std::string& gltf);

// The text of the SceneError, or "accepted".
std::string refusal_of(const std::string& gltf);

std::string base64(const std::string& bytes);

}  // namespace amalgam::scene
