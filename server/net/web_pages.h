// The files of a page for browsers: embedded ones, or those of a folder for whoever works on them.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "web/web_files.h"

namespace amalgam::net {

struct WebPage {
  std::string_view content_type;
  std::string tag;         // changes with the bytes
  std::string own;         // bytes made for this answer
  std::string_view fixed;  // embedded bytes, which outlive everything, or those that kept holds
  std::shared_ptr<const void> kept{};

  std::string_view bytes() const { return fixed.data() ? fixed : std::string_view(own); }
};

// A page of bytes that were made. path: says by its end what they are.
WebPage made_page(std::string_view path, std::string bytes);

// folder: empty, or where files are read anew for each request instead of looked up in `files`.
// Nothing if there is no such file. path: as in a request, "/" for the page itself.
std::optional<WebPage> find_web_page(std::span<const web::WebFile> files, const std::string& folder,
                                     std::string_view path);

}  // namespace amalgam::net
