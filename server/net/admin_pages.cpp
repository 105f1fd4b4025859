#include "net/admin_pages.h"

#include <boost/beast/http/field.hpp>
#include <boost/beast/http/verb.hpp>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace amalgam::net {
namespace {

namespace http = boost::beast::http;

// The status page has nothing but its own files, and nothing may show it in a frame.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

constexpr const char* kOthers = "/livez /readyz /metrics /state\n";

struct Found {
  http::status status;
  WebPage page;
};

Found text(http::status status, std::string line) {
  return {status, text_page(std::move(line))};
}

Found probe(const std::string& reason) {
  return reason.empty() ? text(http::status::ok, "ok\n")
                        : text(http::status::service_unavailable, reason + "\n");
}

// Of /pictures/7.jpg: 7.
std::optional<std::uint64_t> session_of(std::string_view path) {
  constexpr std::string_view kFolder = "/pictures/", kEnding = ".jpg";
  if (!path.starts_with(kFolder) || !path.ends_with(kEnding)) return std::nullopt;
  path.remove_prefix(kFolder.size());
  if (path.size() <= kEnding.size()) return std::nullopt;
  path.remove_suffix(kEnding.size());
  std::uint64_t session = 0;
  const auto [end, failed] = std::from_chars(path.data(), path.data() + path.size(), session);
  if (failed != std::errc() || end != path.data() + path.size()) return std::nullopt;
  return session;
}

Found picture_of(std::uint64_t session, const AdminPages& pages) {
  Picture picture = pages.picture(session);
  if (auto* reason = std::get_if<std::string>(&picture)) {
    return text(http::status::not_found, std::move(*reason) + "\n");
  }
  auto& bytes = std::get<std::shared_ptr<const frame::Bytes>>(picture);
  const std::string_view view(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  return {http::status::ok, {"image/jpeg", "", "", view, std::move(bytes)}};
}

Found look_up(std::string_view path, const AdminPages& pages) {
  if (path == "/livez") return probe(pages.not_alive());
  if (path == "/readyz") return probe(pages.not_ready());
  if (path == "/metrics") {
    return {http::status::ok,
            {"text/plain; version=0.0.4; charset=utf-8", "", pages.metrics(), {}, {}}};
  }
  if (path == "/state") {
    return {http::status::ok, {"application/json", "", pages.state() + "\n", {}, {}}};
  }
  if (const auto session = session_of(path)) return picture_of(*session, pages);
  if (path == "/" && pages.files.empty()) {
    return text(
        http::status::not_found,
        std::string("This server was built without the status page. There are: ") + kOthers);
  }
  return text(http::status::not_found, kOthers);
}

}  // namespace

WebAnswer admin_answer(const AdminRequest& request, const AdminPages& pages) {
  WebHead head(http::status::ok, request.version());
  head.keep_alive(request.keep_alive());
  // Pages from elsewhere that somebody looks at may not show what is here.
  head.set("Cross-Origin-Resource-Policy", "same-origin");
  const bool get = request.method() == http::verb::get;
  if (!get && request.method() != http::verb::head) {
    head.result(http::status::method_not_allowed);
    head.set(http::field::allow, "GET, HEAD");
    return web_answer(std::move(head), text_page("GET and HEAD only\n"), kContentSecurityPolicy,
                      true);
  }
  const std::string_view path = path_of(request);
  if (auto file = find_web_page(pages.files, "", path)) {
    return file_answer(std::move(head), std::move(*file), kContentSecurityPolicy, request);
  }
  Found found = look_up(path, pages);
  head.result(found.status);
  head.set(http::field::cache_control, "no-store");
  return web_answer(std::move(head), std::move(found.page), kContentSecurityPolicy, get);
}

}  // namespace amalgam::net
