// URIs in a glTF file: relative file names and base64 data URIs.
#pragma once

#include <string>

#include "scene/gltf/check/json_value.h"

namespace amalgam::scene {

bool is_data_uri(const std::string& uri);

// %XX undone. Throws SceneError for a broken escape or a zero byte.
std::string decode_percent(const JsonCursor& uri);

// Throw unless the URI is a well-formed data URI of a fitting kind (for a buffer, of byte_length
// bytes), or a relative path without a scheme. SceneFolder checks whether the file exists.
void check_buffer_uri(const JsonCursor& uri, long long byte_length);
void check_image_uri(const JsonCursor& uri);

}  // namespace amalgam::scene
