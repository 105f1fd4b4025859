#include "net/admin_pages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <boost/beast/http/field.hpp>

namespace amalgam::net {
namespace {

namespace http = boost::beast::http;
using http::verb;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr std::array<web::WebFile, 2> kFiles{
    {{"index.html", "text/html", "<p>", "\"7\""}, {"main.js", "text/javascript", "{}", "\"8\""}}};

AdminPages pages() {
  return {.not_alive = [] { return ""; },
          .not_ready = [] { return "full"; },
          .metrics = [] { return "a 1\n"; },
          .state = [] { return "{}"; },
          .picture = [](std::uint64_t session) -> Picture {
            if (session != 7) return "no session " + std::to_string(session);
            return std::make_shared<const frame::Bytes>(3, std::byte{'j'});
          },
          .files = kFiles};
}

AdminRequest request(const char* target, verb method = verb::get) {
  return AdminRequest(method, target, 11);
}

std::string said(const AdminRequest& asked, const AdminPages& by = pages()) {
  const WebAnswer answer = admin_answer(asked, by);
  return answer.head + std::string(answer.page.bytes());
}

TEST(AdminPages, TheStatusPageComesWithWhatKeepsItSafe) {
  const std::string answer = said(request("/"));
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(answer, HasSubstr("Content-Type: text/html\r\n"));
  EXPECT_THAT(answer,
              HasSubstr("Content-Security-Policy: default-src 'none'; script-src 'self'; "));
  EXPECT_THAT(answer, Not(HasSubstr("unsafe")));
  EXPECT_THAT(answer, HasSubstr("frame-ancestors 'none'"));
  EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff\r\n"));
  EXPECT_THAT(answer, HasSubstr("Cross-Origin-Resource-Policy: same-origin\r\n"));
  EXPECT_THAT(answer, EndsWith("\r\n\r\n<p>"));
  EXPECT_THAT(said(request("/main.js?x")), HasSubstr("Content-Type: text/javascript\r\n"));
}

TEST(AdminPages, AFileIsSentAgainOnlyIfItHasChanged) {
  AdminRequest again = request("/");
  again.set(http::field::if_none_match, "\"7\"");
  EXPECT_THAT(said(again), StartsWith("HTTP/1.1 304 Not Modified\r\n"));
  EXPECT_THAT(said(again), EndsWith("\r\n\r\n"));
  again.set(http::field::if_none_match, "\"8\"");
  EXPECT_THAT(said(again), StartsWith("HTTP/1.1 200 OK\r\n"));
}

TEST(AdminPages, WithoutThePageItSaysWhatElseThereIs) {
  AdminPages bare = pages();
  bare.files = {};
  const std::string answer = said(request("/"), bare);
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(answer, HasSubstr("built without the status page"));
  EXPECT_THAT(answer, HasSubstr("/livez /readyz /metrics /state"));
  EXPECT_THAT(said(request("/main.js"), bare), StartsWith("HTTP/1.1 404 "));
}

TEST(AdminPages, WhatMonitoringAsksForIsAsItWas) {
  EXPECT_THAT(said(request("/livez")), EndsWith("\r\n\r\nok\n"));
  EXPECT_THAT(said(request("/readyz")), StartsWith("HTTP/1.1 503 "));
  EXPECT_THAT(said(request("/readyz")), EndsWith("\r\n\r\nfull\n"));
  EXPECT_THAT(said(request("/metrics")), HasSubstr("text/plain; version=0.0.4"));
  EXPECT_THAT(said(request("/state")), HasSubstr("application/json"));
  EXPECT_THAT(said(request("/state")), HasSubstr("Cache-Control: no-store\r\n"));
  EXPECT_THAT(said(request("/", verb::post)), StartsWith("HTTP/1.1 405 "));
  const std::string head = said(request("/metrics", verb::head));
  EXPECT_THAT(head, HasSubstr("Content-Length: 4\r\n"));
  EXPECT_THAT(head, EndsWith("\r\n\r\n"));
}

TEST(AdminPages, ConnectionsStayIfTheAskerWantsThat) {
  AdminRequest old = AdminRequest(verb::get, "/livez", 10);
  EXPECT_THAT(said(old), Not(HasSubstr("keep-alive")));
  old.keep_alive(true);
  EXPECT_THAT(said(old), HasSubstr("Connection: keep-alive\r\n"));
  AdminRequest last = request("/livez");
  last.keep_alive(false);
  EXPECT_THAT(said(last), HasSubstr("Connection: close\r\n"));
}

TEST(AdminPages, PicturesAreAskedForByTheNumberOfTheSession) {
  const std::string answer = said(request("/pictures/7.jpg?41"));
  EXPECT_THAT(answer, HasSubstr("Content-Type: image/jpeg\r\n"));
  EXPECT_THAT(answer, HasSubstr("Cache-Control: no-store\r\n"));
  EXPECT_THAT(answer, EndsWith("\r\n\r\njjj"));
  const std::string missing = said(request("/pictures/8.jpg"));
  EXPECT_THAT(missing, StartsWith("HTTP/1.1 404 "));
  EXPECT_THAT(missing, EndsWith("\r\n\r\nno session 8\n"));
  for (const char* odd :
       {"/pictures/", "/pictures/.jpg", "/pictures/7", "/pictures/7.jpg/", "/pictures/07x.jpg",
        "/pictures/-7.jpg", "/pictures/ 7.jpg", "/pictures/99999999999999999999.jpg"}) {
    EXPECT_THAT(said(request(odd)), EndsWith("/livez /readyz /metrics /state\n")) << odd;
  }
}

}  // namespace
}  // namespace amalgam::net
