// What is WebSocket's own: opening, kinds of frames, farewells, and who may open a session. What
// holds on every transport is tested for each (support/net/each_transport.h).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "protocol/limits.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using protocol::Error;
using testing::HasSubstr;

std::string upgrade(const common::HostPort& server, const std::string& origin,
                    const std::string& version = "13") {
  return "GET /session HTTP/1.1\r\nHost: " + to_string(server) +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
         "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: " +
         version + (origin.empty() ? "" : "\r\nOrigin: " + origin) + "\r\n\r\n";
}

// A frame of a client, with a mask of zeros. first: FIN and the kind.
std::string web_frame(unsigned char first, const std::string& payload, bool masked = true) {
  std::string frame(1, static_cast<char>(first));
  frame += static_cast<char>(payload.size() | (masked ? 0x80 : 0));
  if (masked) frame += std::string(4, '\0');
  return frame + payload;
}

// To the answer, the rest of which is the server's frames.
std::string first_bytes(TestClient& client, std::size_t most = 4096) {
  std::string bytes(most, '\0');
  bytes.resize(client.receive_raw(bytes.size(), bytes.data()));
  return bytes;
}

TEST(WebSessions, TheAnswerIsWebSockets) {
  TestServer server(test_config(), Over::WebSocket);
  TestClient client(server.address());
  client.send_raw(upgrade(server.address(), "http://" + to_string(server.address())));
  const std::string answer = first_bytes(client);
  EXPECT_THAT(answer, testing::StartsWith("HTTP/1.1 101 "));
  // SHA-1 of the key and RFC 6455's own text.
  EXPECT_THAT(answer, HasSubstr("Sec-WebSocket-Accept: ICX+Yqv66kxgM0FcWaLWlFLwTAI=\r\n"));
  EXPECT_THAT(answer, testing::Not(HasSubstr("permessage-deflate")));
  // Each message is one binary frame, without a mask: here a Welcome of less than 126 bytes.
  client.send_raw(web_frame(0x82, hello_message().SerializeAsString()));
  const std::string frame = first_bytes(client);
  ASSERT_GT(frame.size(), 2u);
  EXPECT_EQ(frame[0], '\x82');
  EXPECT_LE(static_cast<std::size_t>(frame[1]), frame.size() - 2);  // a Ping may follow
  EXPECT_EQ(frame[2], '\x3a');
}

TEST(WebSessions, BadOpeningsAreRefused) {
  TestServer server(test_config(), Over::WebSocket);
  const common::HostPort& to = server.address();
  EXPECT_EQ(http_exchange(to, upgrade(to, "http://evil.example")).status, 403);
  EXPECT_EQ(http_exchange(to, upgrade(to, "", "12")).status, 426);
  // Frames before the answer.
  EXPECT_EQ(http_exchange(to, upgrade(to, "") + web_frame(0x82, "x")).status, 400);
  EXPECT_EQ(server.service.opened(), 0u);
}

TEST(WebSessions, TextIsRefused) {
  TestServer server(test_config(), Over::WebSocket);
  TestClient client = server.connect();
  // A good Envelope, a Goodbye: as a binary message it would be out of turn.
  client.send_raw(web_frame(0x81, std::string("\x32\0", 2)));
  client.expect_error(Error::PROTOCOL_ERROR);
  EXPECT_TRUE(client.closed_by_server());
}

TEST(WebSessions, FragmentsAreOneMessageAndCountTogether) {
  TestServer server(test_config(), Over::WebSocket);
  TestClient client = server.connect();
  const std::string hello = hello_message().SerializeAsString();
  client.send_raw(web_frame(0x02, hello.substr(0, 1)) + web_frame(0x00, "") +
                  web_frame(0x89, "between") + web_frame(0x00, hello.substr(1, 20)) +
                  web_frame(0x80, hello.substr(21)));
  client.expect(Envelope::kWelcome);

  TestClient stranger = server.connect();
  stranger.send_raw(web_frame(0x02, "\x0a" + std::string(99, '\x80')));
  for (std::size_t sent = 100; sent <= protocol::kMaxBeforeHelloBytes; sent += 100) {
    if (!stranger.send_raw(web_frame(0x00, std::string(100, 'x')))) break;
  }
  stranger.expect_error(Error::PROTOCOL_ERROR);
}

TEST(WebSessions, FramesWithoutAMaskEndTheSession) {
  TestServer server(test_config(), Over::WebSocket);
  TestClient client = server.session();
  client.send_raw(web_frame(0x82, "x", false));
  EXPECT_TRUE(client.closed_by_server());
  EXPECT_TRUE(server.service.wait_views(0));
}

TEST(WebSessions, ABrowsersCloseIsAnswered) {
  TestServer server(test_config(), Over::WebSocket);
  TestClient client(server.address());
  client.send_raw(upgrade(server.address(), ""));
  first_bytes(client);
  client.send_raw(web_frame(0x82, hello_message().SerializeAsString()));
  first_bytes(client);
  client.send_raw(web_frame(0x88, "\x03\xe8"));
  std::string farewell = first_bytes(client);
  if (farewell == "\x82\x04\x22\x02\x08\x01") farewell = first_bytes(client);  // the first Ping
  EXPECT_THAT(farewell, testing::EndsWith("\x88\x02\x03\xe8"));
  EXPECT_EQ(first_bytes(client), "");
  EXPECT_TRUE(server.service.wait_views(0));
}

// The server's own farewell comes behind its last message.
TEST(WebSessions, TheServersCloseComesLast) {
  TestServer server(test_config(), Over::WebSocket);
  TestClient client = server.connect();
  client.send(frame_message(1));
  client.expect_error(Error::UNEXPECTED_MESSAGE);
  EXPECT_TRUE(client.closed_by_server());
  EXPECT_EQ(client.web_close_code(), 1000);
}

// WebSocket's pings tell nothing about whether composites are read, so they do not count.
TEST(WebSessions, PingsOfWebSocketAreAnsweredButAreNoSignOfLife) {
  net::ServerConfig config = test_config();
  config.session.idle_timeout = std::chrono::milliseconds(500);
  config.session.ping_interval = std::chrono::milliseconds(100);
  TestServer server(config, Over::WebSocket);
  TestClient client = server.session();
  client.answer_pings(false);
  std::thread pinging([&] {
    for (int i = 0; i < 100 && client.send_raw(web_frame(0x89, "?")); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  client.expect_error(Error::IDLE_TIMEOUT);
  pinging.join();
}

TEST(WebSessions, TheStateTellsTheTransport) {
  TestServer server(test_config(), Over::WebSocket);
  TestClient web = server.session();
  TestClient tcp(server.server().address());
  tcp.send(hello_message());
  tcp.expect(Envelope::kWelcome);
  const std::string state = server.admin("/state").body;
  EXPECT_THAT(state, HasSubstr("\"transport\": \"tcp\""));
  EXPECT_THAT(state, HasSubstr("\"transport\": \"websocket\""));
}

TEST(WebSessions, DrainingEndsThemAsOverTcp) {
  TestServer server(test_config(), Over::WebSocket);
  TestClient busy = server.session();
  TestClient stranger = server.connect();
  server.service.hold();
  busy.send(frame_message(1));
  ASSERT_TRUE(server.service.wait_taken(1));
  server.server().drain();
  busy.expect(Envelope::kDraining);
  stranger.expect(Envelope::kDraining);
  EXPECT_TRUE(stranger.closed_by_server());
  EXPECT_THROW(server.connect(), std::runtime_error);
  server.service.release();
  EXPECT_EQ(busy.expect(Envelope::kComposite).composite().frame_id(), 1u);
  EXPECT_TRUE(busy.closed_by_server());
  server.join();
}

}  // namespace
}  // namespace amalgam::test
