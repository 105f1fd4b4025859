// What operators see in a browser: the status page's files, what it is fed by, and the pictures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <future>
#include <nlohmann/json.hpp>

#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using testing::HasSubstr;

const std::string kLarge(300'000, 'w');
const std::array<web::WebFile, 2> kFiles{
    {{"index.html", "text/html", "<p>", "\"1\""}, {"main.js", "text/javascript", kLarge, "\"2\""}}};

net::ServerConfig with_status_page() {
  net::ServerConfig config = test_config();
  config.status_files = kFiles;
  return config;
}

net::ServerConfig with_pictures() {
  net::ServerConfig config = test_config();
  config.admin_pictures = true;
  return config;
}

void send_frame(TestClient& client, std::uint64_t id, std::string_view jpeg) {
  client.send(frame_message(id, jpeg));
  client.expect(Envelope::kComposite);
}

std::string picture_of(std::uint64_t session) {
  return "/pictures/" + std::to_string(session) + ".jpg";
}

std::uint64_t number_of_only_session(TestServer& server) {
  return nlohmann::json::parse(server.admin("/state").body)["sessions"].at(0)["id"];
}

TEST(Status, ThePageComesFromTheAdminPortAlone) {
  TestServer server(with_status_page(), Over::WebSocket);
  EXPECT_EQ(server.admin("/").body, "<p>");
  EXPECT_TRUE(server.admin("/main.js").body == kLarge);
  EXPECT_EQ(server.admin("/other.js").status, 404);
  EXPECT_EQ(server.admin("/../etc/passwd").status, 404);
  EXPECT_EQ(http_get(server.address(), "/main.js").status, 404);
  const HttpAnswer known = http_exchange(server.server().admin_address(),
                                         "GET / HTTP/1.0\r\nIf-None-Match: \"1\"\r\n\r\n");
  EXPECT_EQ(known.status, 304);
  EXPECT_EQ(known.body, "");
}

TEST(Status, AServerWithoutThePageSaysSo) {
  TestServer server;
  EXPECT_EQ(server.admin("/").status, 404);
  EXPECT_THAT(server.admin("/").body, HasSubstr("built without the status page"));
}

// One connection for many requests, as browsers and Prometheus have it.
TEST(Status, ManyAnswersComeOverOneConnection) {
  TestServer server(with_status_page());
  TestClient browser(server.server().admin_address());
  std::string text(400'000, '\0');
  browser.send_raw("GET /livez HTTP/1.1\r\nHost: x\r\n\r\n");
  ASSERT_GT(browser.receive_raw(text.size(), text.data()), 0u);
  EXPECT_THAT(text.c_str(), testing::EndsWith("ok\n"));
  browser.send_raw("GET /main.js HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n");
  std::size_t size = 0, part = 0;
  while ((part = browser.receive_raw(text.size() - size, text.data() + size)) > 0) size += part;
  EXPECT_GT(size, kLarge.size());
  EXPECT_TRUE(text.substr(0, size).ends_with(kLarge));
}

TEST(Status, StateTellsWhatThePageShows) {
  net::ServerConfig config = test_config();
  config.connections.total = 20;
  config.admission.load = 0.5;
  TestServer server(config);
  frame::ServiceLoad load;
  load.demand = 0.25;
  load.queue_age = std::chrono::milliseconds(70);
  server.service.set_load(load);
  TestClient client = server.session();
  TestClient stranger = server.connect();
  for (std::uint64_t id = 1; id <= 3; ++id) send_frame(client, id, "jpeg");
  client.send(frame_message(4, kBadJpeg));
  client.expect_error(protocol::Error::BAD_IMAGE);

  const auto state = nlohmann::json::parse(server.admin("/state").body);
  EXPECT_EQ(state["alive"], true);
  EXPECT_EQ(state["admin_pictures"], false);
  EXPECT_GE(state["cores"], 1);
  EXPECT_EQ(state["queue_age_ms"], 70);
  const auto& limits = state["limits"];
  EXPECT_EQ(limits["connections"], (nlohmann::json{{"used", 2.0}, {"most", 20.0}}));
  EXPECT_EQ(limits["unauthenticated"]["used"], 1.0);
  EXPECT_EQ(limits["load"], (nlohmann::json{{"used", 0.25}, {"most", 0.5}}));
  EXPECT_GT(limits["session_memory"]["used"], 1e6);
  EXPECT_GT(limits["descriptors"]["used"], 3.0);
  EXPECT_GT(limits["descriptors"]["most"], limits["descriptors"]["used"]);
  const auto& session = state["sessions"].at(0);
  EXPECT_EQ(session["frames_received"], 4);
  EXPECT_EQ(session["frames_sent"], 3);
  EXPECT_EQ(session["skipped_by"]["refused"], 1);
  EXPECT_EQ(session["frames_unchanged"], 3);
  // Four within a second or so; on a machine that is busy, within the five that are looked at.
  EXPECT_GT(session["frames_asked_per_second"], 0.7);
  EXPECT_GT(session["frames_served_per_second"], 0.5);
  EXPECT_GT(session["bytes_received"], 40);
  EXPECT_GT(session["bytes_sent"], session["bytes_received"]);  // with times and passes
  EXPECT_GT(session["server_ms_median"], 0.0);
  EXPECT_EQ(session["stages_ms"]["trace"], 1.5);
  EXPECT_EQ(session["passes"].at(1)["reason"], "no lens distortion");
  EXPECT_EQ(session["picture"], false);
}

TEST(Status, NoPictureIsKeptUnlessTheOperatorWantsThat) {
  TestServer server;
  TestClient client = server.session();
  send_frame(client, 1, "desk");
  const HttpAnswer answer = server.admin(picture_of(number_of_only_session(server)));
  EXPECT_EQ(answer.status, 404);
  EXPECT_THAT(answer.body, HasSubstr("--admin-pictures"));
}

TEST(Status, TheLastPictureOfASessionGoesWithIt) {
  TestServer server(with_pictures());
  TestClient client = server.session();
  const std::string path = picture_of(number_of_only_session(server));
  EXPECT_EQ(server.admin(path).status, 404);
  send_frame(client, 1, "first");
  send_frame(client, 2, "second");
  const HttpAnswer answer = server.admin(path);
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(answer.body, "second");
  EXPECT_THAT(answer.head, HasSubstr("image/jpeg"));
  EXPECT_THAT(answer.head, HasSubstr("no-store"));
  EXPECT_EQ(server.admin(picture_of(99)).status, 404);
  client.finish_sending();
  EXPECT_TRUE(client.closed_by_server());
  const HttpAnswer gone = server.admin(path);
  EXPECT_EQ(gone.status, 404);
  EXPECT_THAT(gone.body, HasSubstr("is not there"));
}

// A reload turns it off while sessions are open.
TEST(Status, PicturesAreForgottenWhenTheyAreNotWantedAnyMore) {
  TestServer server(with_pictures());
  TestClient client = server.session();
  send_frame(client, 1, "desk");
  const std::string path = picture_of(number_of_only_session(server));
  EXPECT_EQ(server.admin(path).body, "desk");
  const auto configure = [&](const net::ServerConfig& config) {
    std::promise<void> done;
    server.server().post([&] {
      server.server().configure(config, nullptr);
      done.set_value();
    });
    done.get_future().get();
  };
  configure(test_config());
  EXPECT_EQ(server.admin(path).status, 404);
  configure(with_pictures());
  EXPECT_EQ(server.admin(path).status, 404);  // it was forgotten, and not only hidden
  send_frame(client, 2, "lamp");
  EXPECT_EQ(server.admin(path).body, "lamp");
}

}  // namespace
}  // namespace amalgam::test
