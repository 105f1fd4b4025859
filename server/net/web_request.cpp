#include "net/web_request.h"

#include <algorithm>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/http/verb.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <optional>
#include <utility>

namespace amalgam::net {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;

// The page has scripts, styles and workers of its own, WebAssembly for finding markers, pictures
// that it makes itself, and talks to the server that it comes from. Nothing may show it in a frame.
constexpr const char* kContentSecurityPolicy =
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; "
    "img-src 'self' blob: data:; connect-src 'self' ws: wss:; media-src 'self' blob:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

// One request a connection: places are few, and a browser keeps its connections for minutes.
WebHead head_of(http::status status) {
  WebHead head(status, 11);
  head.set(http::field::connection, "close");
  return head;
}

WebAnswer refusal(http::status status, const std::string& line,
                  std::initializer_list<std::pair<http::field, const char*>> fields = {}) {
  WebHead head = head_of(status);
  for (const auto& [field, value] : fields) head.set(field, value);
  head.set(http::field::cache_control, "no-store");
  return web_answer(std::move(head), text_page(line + "\n"), kContentSecurityPolicy, true);
}

WebAnswer page_answer(const WebRequest& request, const WebOptions& options, std::string_view path) {
  std::optional<WebPage> page = find_web_page(options.files, options.folder, path);
  if (page) {
    return file_answer(head_of(http::status::ok), std::move(*page), kContentSecurityPolicy,
                       request);
  }
  const bool no_page = path == "/" && options.files.empty() && options.folder.empty();
  return refusal(http::status::not_found,
                 no_page ? "This server was built without the page." : "there is no such file");
}

// What may be asked for instead; empty if nothing of the path is made.
std::string choices(const WebOptions& options, const std::string& path) {
  std::string text;
  for (const auto& [target, make] : options.made) {
    if (target.starts_with(path + '?')) text += (text.empty() ? "" : " or ") + target;
  }
  return text;
}

}  // namespace

std::variant<Upgrade, WebAnswer, MadeFile> judge(const WebRequest& request,
                                                 const WebOptions& options) {
  const beast::string_view target = request.target();
  const std::string_view whole(target.data(), target.size());
  const std::string_view path = path_of(request);
  if (path == kSessionPath) {
    if (!beast::websocket::is_upgrade(request)) {
      return refusal(http::status::upgrade_required, "sessions are held over WebSocket",
                     {{http::field::upgrade, "websocket"}});
    }
    if (!is_welcome(request, options.origins)) {
      return refusal(http::status::forbidden, "pages from there may not open sessions here");
    }
    return Upgrade{};
  }
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    return refusal(http::status::method_not_allowed, "GET and HEAD only",
                   {{http::field::allow, "GET, HEAD"}});
  }
  if (options.made.contains(whole)) return MadeFile{std::string(whole)};
  if (const std::string known = choices(options, std::string(path)); !known.empty()) {
    return refusal(http::status::not_found, "there is " + known);
  }
  return page_answer(request, options, path);
}

WebAnswer answer_with(const WebRequest& request, const MadeFiles::Result& made) {
  if (const auto* missing = std::get_if<MadeFiles::Missing>(&made)) {
    return refusal(http::status::not_found, missing->why);
  }
  return file_answer(head_of(http::status::ok), std::get<WebPage>(made), kContentSecurityPolicy,
                     request);
}

WebAnswer answer_to_garbage(bool too_long, const std::string& defect) {
  return refusal(
      too_long ? http::status::request_header_fields_too_large : http::status::bad_request, defect);
}

std::string busy_answer(std::chrono::milliseconds retry_after, const std::string& reason) {
  const std::string seconds = std::to_string((retry_after.count() + 999) / 1000);
  const WebAnswer said = refusal(http::status::service_unavailable, reason,
                                 {{http::field::retry_after, seconds.c_str()}});
  return said.head + std::string(said.page.bytes());
}

bool is_welcome(const WebRequest& request, const std::vector<std::string>& origins) {
  const auto count = request.count(http::field::origin);
  if (count == 0) return true;
  if (count > 1 || request.count(http::field::host) != 1) return false;
  const beast::string_view origin = request[http::field::origin];
  if (!origins.empty()) {
    return std::any_of(origins.begin(), origins.end(),
                       [&](const std::string& allowed) { return beast::iequals(origin, allowed); });
  }
  const std::size_t scheme = origin.find("://");
  return scheme != beast::string_view::npos &&
         beast::iequals(origin.substr(scheme + 3), request[http::field::host]);
}

}  // namespace amalgam::net
