#include "net/web_answer.h"

#include <boost/beast/core/string.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/http/verb.hpp>
#include <boost/beast/http/write.hpp>
#include <sstream>
#include <utility>

namespace amalgam::net {

namespace beast = boost::beast;
namespace http = beast::http;

WebPage text_page(std::string text) {
  return {"text/plain; charset=utf-8", "", std::move(text), {}, {}};
}

WebAnswer web_answer(WebHead head, WebPage page, const char* policy, bool with_bytes) {
  head.set("Content-Security-Policy", policy);
  head.set("X-Content-Type-Options", "nosniff");
  head.set("Referrer-Policy", "no-referrer");
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

WebAnswer file_answer(WebHead head, WebPage page, const char* policy,
                      const WebRequestHead& request) {
  head.set(http::field::cache_control, "no-cache");
  head.set(http::field::etag, page.tag);
  const bool known = request[http::field::if_none_match] == page.tag;
  if (known) head.result(http::status::not_modified);
  const bool get = request.method() == http::verb::get;
  return web_answer(std::move(head), std::move(page), policy, get && !known);
}

std::string_view path_of(const WebRequestHead& request) {
  const beast::string_view target = request.target();
  const std::string_view whole(target.data(), target.size());
  return whole.substr(0, whole.find('?'));
}

}  // namespace amalgam::net
