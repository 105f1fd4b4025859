#include "net/web_request.h"

#include <algorithm>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/http/verb.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <sstream>
#include <utility>

namespace amalgam::net {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using Head = http::response<http::empty_body>;

// The page has scripts, styles and workers of its own, WebAssembly for finding markers, pictures
// that it makes itself, and talks to the server that it comes from. Nothing may show it in a frame.
constexpr const char* kContentSecurityPolicy =
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; "
    "img-src 'self' blob: data:; connect-src 'self' ws: wss:; media-src 'self' blob:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

constexpr std::string_view kText = "text/plain; charset=utf-8";

// One request a connection: places are few, and a browser keeps its connections for minutes.
WebAnswer answer(Head head, WebPage page, bool with_bytes) {
  head.set("Content-Security-Policy", kContentSecurityPolicy);
  head.set("X-Content-Type-Options", "nosniff");
  head.set("Referrer-Policy", "no-referrer");
  head.set(http::field::connection, "close");
  if (head.result() != http::status::not_modified) {
    head.set(http::field::content_type,
             beast::string_view(page.content_type.data(), page.content_type.size()));
    head.content_length(page.bytes().size());
  }
  if (!with_bytes) page = WebPage();
  std::ostringstream text;
  text << head.base();
  return {text.str(), std::move(page)};
}

WebPage text_page(const std::string& line) {
  return {kText, "", line + "\n", {}};
}

WebAnswer refusal(http::status status, const std::string& line,
                  std::initializer_list<std::pair<http::field, const char*>> fields = {}) {
  Head head(status, 11);
  for (const auto& [field, value] : fields) head.set(field, value);
  head.set(http::field::cache_control, "no-store");
  return answer(std::move(head), text_page(line), true);
}

// Of a file that there is.
WebAnswer file_answer(const WebRequest& request, WebPage page) {
  Head head(http::status::ok, 11);
  // Asked for again each time, but sent again only if it has changed.
  head.set(http::field::cache_control, "no-cache");
  head.set(http::field::etag, page.tag);
  const bool known = request[http::field::if_none_match] == page.tag;
  if (known) head.result(http::status::not_modified);
  return answer(std::move(head), std::move(page), request.method() == http::verb::get && !known);
}

WebAnswer page_answer(const WebRequest& request, const WebOptions& options, std::string_view path) {
  std::optional<WebPage> page = find_web_page(options.files, options.folder, path);
  if (page) return file_answer(request, std::move(*page));
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
  const std::string_view path = whole.substr(0, whole.find('?'));
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
  return file_answer(request, std::get<WebPage>(made));
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
