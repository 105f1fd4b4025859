// The pages for browsers, as the build embedded them.
#pragma once

#include <span>
#include <string_view>

namespace amalgam::web {

struct WebFile {
  std::string_view path;  // below the root, as "index.html" or "workers/markers.js"
  std::string_view content_type;
  std::string_view bytes;
  std::string_view tag;  // changes with the bytes: an ETag, with its quotation marks
};

// Each is empty if the server was built without it.
std::span<const WebFile> web_files();     // the page with the camera, at the web port
std::span<const WebFile> status_files();  // the page for operators, at the admin port

}  // namespace amalgam::web
