// URIs in a glTF file: relative file names and base64 data URIs.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/check/check_context.h"

namespace amalgam::scene {

bool is_data_uri(const std::string& uri);

// %XX undone; a % that begins no escape stands for itself, as does a +. Throws SceneError for a
// zero byte.
std::string decode_percent(const JsonCursor& uri);

// The bytes of a data URI. Throws SceneError if it is not base64.
std::vector<unsigned char> decode_data_uri(const JsonCursor& uri);

// Throw unless the URI is a base64 data URI (for a buffer, of at least byte_length bytes), or a
// relative path without a scheme. SceneFolder checks whether the file exists.
void check_buffer_uri(const GltfCheckContext& context, const JsonCursor& uri,
                      long long byte_length);
void check_image_uri(const GltfCheckContext& context, const JsonCursor& uri);

}  // namespace amalgam::scene
