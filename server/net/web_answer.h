// Answers over HTTP to browsers: a head with what keeps pages safe, and bytes behind it.
#pragma once

#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <string>
#include <string_view>

#include "net/web_pages.h"

namespace amalgam::net {

struct WebAnswer {
  std::string head;  // up to and with the empty line
  WebPage page;      // its bytes follow
};

// Status and fields, without the bytes.
using WebHead = boost::beast::http::response<boost::beast::http::empty_body>;
// Of any request: what was asked for, and the fields.
using WebRequestHead = boost::beast::http::request_header<>;

WebPage text_page(std::string text);

// policy: a Content-Security-Policy. with_bytes: false if only the head was asked for.
WebAnswer web_answer(WebHead head, WebPage page, const char* policy, bool with_bytes);
// A file of a page: looked for anew each time, but sent again only if it has changed.
WebAnswer file_answer(WebHead head, WebPage page, const char* policy,
                      const WebRequestHead& request);

// Of a request's target, without what stands behind a question mark.
std::string_view path_of(const WebRequestHead& request);

}  // namespace amalgam::net
