#include "net/web_request.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <boost/beast/http/field.hpp>
#include <string>

namespace amalgam::net {
namespace {

namespace http = boost::beast::http;
using http::field;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr std::array<web::WebFile, 1> kFiles{{{"index.html", "text/html", "<p>", "\"7\""}}};

WebOptions options(std::vector<std::string> origins = {}) {
  WebOptions options;
  options.files = kFiles;
  options.origins = std::move(origins);
  return options;
}

WebRequest get(const char* target) {
  WebRequest request(http::verb::get, target, 11);
  request.set(field::host, "desk.example:7449");
  return request;
}

WebRequest upgrade(const char* origin = nullptr) {
  WebRequest request = get("/session");
  request.set(field::upgrade, "websocket");
  request.set(field::connection, "keep-alive, Upgrade");
  request.set(field::sec_websocket_key, "AAAAAAAAAAAAAAAAAAAAAA==");
  request.set(field::sec_websocket_version, "13");
  if (origin) request.set(field::origin, origin);
  return request;
}

// Status line, header fields and bytes; empty for an upgrade.
std::string said(const WebRequest& request, const WebOptions& to = options()) {
  const auto judged = judge(request, to);
  const auto* answer = std::get_if<WebAnswer>(&judged);
  return answer ? answer->head + std::string(answer->page.bytes()) : "";
}

TEST(WebRequest, ThePageComesWithWhatKeepsItSafe) {
  const std::string answer = said(get("/?debug"));
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(answer, HasSubstr("Content-Type: text/html\r\n"));
  EXPECT_THAT(answer, HasSubstr("Content-Length: 3\r\n"));
  EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'self'; "));
  EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff\r\n"));
  EXPECT_THAT(answer, HasSubstr("Connection: close\r\n"));
  EXPECT_THAT(answer, testing::EndsWith("\r\n\r\n<p>"));
}

TEST(WebRequest, WhatTheBrowserHasIsNotSentAgain) {
  WebRequest request = get("/");
  request.set(field::if_none_match, find_web_page(kFiles, "", "/")->tag);
  EXPECT_THAT(said(request), StartsWith("HTTP/1.1 304 Not Modified\r\n"));
  EXPECT_THAT(said(request), testing::EndsWith("\r\n\r\n"));
  request.set(field::if_none_match, "\"another\"");
  EXPECT_THAT(said(request), StartsWith("HTTP/1.1 200 OK\r\n"));
}

TEST(WebRequest, MethodsAndPathsThatThereAreNot) {
  WebRequest request = get("/");
  request.method(http::verb::head);
  EXPECT_THAT(said(request), HasSubstr("Content-Length: 3\r\n"));
  EXPECT_THAT(said(request), testing::EndsWith("\r\n\r\n"));
  request.method(http::verb::post);
  EXPECT_THAT(said(request), StartsWith("HTTP/1.1 405 "));
  EXPECT_THAT(said(request), HasSubstr("Allow: GET, HEAD\r\n"));
  EXPECT_THAT(said(get("/nothing")), StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(said(get("/session")), StartsWith("HTTP/1.1 426 "));
  EXPECT_THAT(said(get("/session")), HasSubstr("Upgrade: websocket\r\n"));
  EXPECT_THAT(said(get("/"), WebOptions{}), HasSubstr("built without the page"));
}

TEST(WebRequest, WhatHasToBeMadeIsLeftToTheCaller) {
  WebOptions with_sheets = options();
  const MakeFile make = [](const frame::FrameService::MarkerSet&) { return std::string(); };
  with_sheets.made = {{"/sheet.pdf?paper=a4", make}, {"/sheet.pdf?paper=letter", make}};
  const WebRequest wanted = get("/sheet.pdf?paper=letter");
  const auto judged = judge(wanted, with_sheets);
  ASSERT_TRUE(std::holds_alternative<MadeFile>(judged));
  EXPECT_EQ(std::get<MadeFile>(judged).target, "/sheet.pdf?paper=letter");
  for (const char* other : {"/sheet.pdf", "/sheet.pdf?paper=a3", "/sheet.pdf?paper=a4&x"}) {
    const std::string refused = said(get(other), with_sheets);
    EXPECT_THAT(refused, StartsWith("HTTP/1.1 404 ")) << other;
    EXPECT_THAT(refused, HasSubstr("there is /sheet.pdf?paper=a4 or /sheet.pdf?paper=letter"));
  }
  EXPECT_THAT(said(get("/sheet"), with_sheets), HasSubstr("there is no such file"));
  WebRequest post = wanted;
  post.method(http::verb::post);
  EXPECT_THAT(said(post, with_sheets), StartsWith("HTTP/1.1 405 "));
}

TEST(WebRequest, WhatWasMadeIsAFileLikeOthers) {
  const auto text = [](const WebAnswer& answer) {
    return answer.head + std::string(answer.page.bytes());
  };
  WebRequest request = get("/sheet.pdf?paper=a4");
  const MadeFiles::Result made = made_page("/sheet.pdf", "%PDF");
  EXPECT_THAT(text(answer_with(request, made)), HasSubstr("Content-Type: application/pdf\r\n"));
  EXPECT_THAT(text(answer_with(request, made)), testing::EndsWith("\r\n\r\n%PDF"));
  request.set(field::if_none_match, std::get<WebPage>(made).tag);
  EXPECT_THAT(text(answer_with(request, made)), StartsWith("HTTP/1.1 304 "));
  const std::string missing = text(answer_with(request, MadeFiles::Missing{"it is too large"}));
  EXPECT_THAT(missing, StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(missing, testing::EndsWith("\r\n\r\nit is too large\n"));
}

TEST(WebRequest, SessionsAreForTheOwnPageAndForPrograms) {
  EXPECT_EQ(said(upgrade()), "");
  EXPECT_EQ(said(upgrade("http://desk.example:7449")), "");
  EXPECT_EQ(said(upgrade("https://DESK.example:7449")), "");
  for (const char* origin :
       {"http://desk.example", "http://desk.example:7448", "http://evil.example:7449", "null", "",
        "http://desk.example:7449.evil.example", "http://evil.example/desk.example:7449"}) {
    EXPECT_THAT(said(upgrade(origin)), StartsWith("HTTP/1.1 403 ")) << origin;
  }
}

TEST(WebRequest, SessionsAreForNamedOriginsOnly) {
  const WebOptions named = options({"https://a.example", "http://b.example:8080"});
  EXPECT_EQ(said(upgrade("https://a.example"), named), "");
  EXPECT_EQ(said(upgrade("http://b.example:8080"), named), "");
  EXPECT_EQ(said(upgrade(), named), "");
  // A name that somebody points at this server makes his page look like its own.
  EXPECT_THAT(said(upgrade("http://desk.example:7449"), named), StartsWith("HTTP/1.1 403 "));
  EXPECT_THAT(said(upgrade("http://a.example"), named), StartsWith("HTTP/1.1 403 "));
}

TEST(WebRequest, TwoOriginsOrHostsAreNone) {
  WebRequest origins = upgrade("http://desk.example:7449");
  origins.insert(field::origin, "http://evil.example");
  EXPECT_THAT(said(origins), StartsWith("HTTP/1.1 403 "));
  WebRequest hosts = upgrade("http://desk.example:7449");
  hosts.insert(field::host, "evil.example");
  EXPECT_THAT(said(hosts), StartsWith("HTTP/1.1 403 "));
}

TEST(WebRequest, WhoIsRefusedIsToldWhenToComeBack) {
  const std::string answer = busy_answer(std::chrono::milliseconds(1001), "too many connections");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 503 Service Unavailable\r\n"));
  EXPECT_THAT(answer, HasSubstr("Retry-After: 2\r\n"));
  EXPECT_THAT(answer, testing::EndsWith("\r\n\r\ntoo many connections\n"));
}

}  // namespace
}  // namespace amalgam::net
