#include "web/content_type.h"

#include <algorithm>
#include <array>
#include <utility>

namespace amalgam::web {
namespace {

using Entry = std::pair<std::string_view, std::string_view>;
constexpr std::array kTypes{
    Entry{".css", "text/css; charset=utf-8"},
    Entry{".html", "text/html; charset=utf-8"},
    Entry{".ico", "image/x-icon"},
    Entry{".jpg", "image/jpeg"},
    Entry{".js", "text/javascript; charset=utf-8"},
    Entry{".json", "application/json"},
    Entry{".map", "application/json"},
    Entry{".mjs", "text/javascript; charset=utf-8"},
    Entry{".mp4", "video/mp4"},
    Entry{".pdf", "application/pdf"},
    Entry{".png", "image/png"},
    Entry{".svg", "image/svg+xml"},
    Entry{".txt", "text/plain; charset=utf-8"},
    Entry{".wasm", "application/wasm"},
    Entry{".webm", "video/webm"},
    Entry{".webmanifest", "application/manifest+json"},
    Entry{".webp", "image/webp"},
    Entry{".woff2", "font/woff2"},
};

}  // namespace

std::string_view content_type(std::string_view path) {
  const auto entry = std::find_if(kTypes.begin(), kTypes.end(),
                                  [&](const Entry& type) { return path.ends_with(type.first); });
  return entry == kTypes.end() ? "application/octet-stream" : entry->second;
}

}  // namespace amalgam::web
