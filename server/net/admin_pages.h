// What the admin port answers: /livez, /readyz, /metrics, /state, the files of the status page, and
// the last composites of sessions if the operator allows that. Decides; knows no sockets.
#pragma once

#include <boost/beast/http/string_body.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <variant>

#include "frame/frame.h"
#include "net/web_answer.h"
#include "web/web_files.h"

namespace amalgam::net {

// A JPEG, or why there is none.
using Picture = std::variant<std::shared_ptr<const frame::Bytes>, std::string>;

// The pages' contents; called for each request.
struct AdminPages {
  std::function<std::string()> not_alive;  // why; empty: the renderer makes progress
  std::function<std::string()> not_ready;  // why; empty: ready
  std::function<std::string()> metrics;    // Prometheus' text format
  std::function<std::string()> state;      // JSON
  std::function<Picture(std::uint64_t session)> picture;
  std::span<const web::WebFile> files;  // of the status page; empty: the server has none
};

using AdminRequest = boost::beast::http::request<boost::beast::http::string_body>;

WebAnswer admin_answer(const AdminRequest& request, const AdminPages& pages);

}  // namespace amalgam::net
