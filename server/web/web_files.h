// The page that browsers get, as the build embedded it.
#pragma once

#include <span>
#include <string_view>

namespace amalgam::web {

struct WebFile {
  std::string_view path;  // below the root, as "index.html" or "workers/markers.js"
  std::string_view content_type;
  std::string_view bytes;
};

// Empty if the server was built without the page.
std::span<const WebFile> web_files();

}  // namespace amalgam::web
