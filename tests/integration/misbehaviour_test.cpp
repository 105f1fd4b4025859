// What clients that break the protocol are told, and that nobody else notices.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "protocol/limits.h"
#include "support/net/each_transport.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using protocol::Error;

class Misbehaviour : public EachTransport {};

// The client is told this code and closed, and its view is gone.
void expect_refused(TestServer& server, TestClient& client, Error::Code code) {
  const Error error = client.expect_error(code);
  EXPECT_TRUE(error.closes());
  EXPECT_FALSE(error.text().empty());
  EXPECT_TRUE(client.closed_by_server());
  EXPECT_TRUE(server.service.wait_views(0));
}

std::string length_prefix(std::uint32_t length) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>((length >> (8 * i)) & 0xff));
  return bytes;
}

// Behind a length that is refused: WebSocket tells of a message only when it has begun.
std::string beginning(Over over) {
  return over == Over::WebSocket ? "\x12" : "";
}

TEST_P(Misbehaviour, BeforeTheHello) {
  TestServer server(test_config(), GetParam());
  const std::string more = beginning(GetParam());
  struct Row {
    const char* name;
    std::string bytes;
    Error::Code code;
  };
  Envelope wrong_version = hello_message();
  wrong_version.mutable_hello()->set_version(2);
  Envelope no_camera = hello_message();
  no_camera.mutable_hello()->clear_camera();
  Envelope zero_focal_length = hello_message();
  zero_focal_length.mutable_hello()->mutable_camera()->set_fx(0);
  Envelope ping;
  ping.mutable_ping();
  Envelope welcome;
  welcome.mutable_welcome();
  const std::vector<Row> rows{
      {"wrong version", encode(wrong_version), Error::UNSUPPORTED_VERSION},
      {"no camera", encode(no_camera), Error::BAD_HELLO},
      {"focal length 0", encode(zero_focal_length), Error::BAD_HELLO},
      {"frame", encode(frame_message(1)), Error::UNEXPECTED_MESSAGE},
      {"ping", encode(ping), Error::UNEXPECTED_MESSAGE},
      {"a server's message", encode(welcome), Error::UNEXPECTED_MESSAGE},
      {"unknown kind", length_prefix(3) + "\x7a\x01x", Error::UNKNOWN_MESSAGE},
      {"no envelope", length_prefix(3) + "\xff\xff\xff", Error::PROTOCOL_ERROR},
      {"length 0", length_prefix(0), Error::PROTOCOL_ERROR},
      {"length above the limit", length_prefix(4097) + more, Error::PROTOCOL_ERROR},
      {"length 2^31", length_prefix(0x80000000u) + more, Error::PROTOCOL_ERROR},
      {"length 2^32 - 1", length_prefix(0xffffffffu) + more, Error::PROTOCOL_ERROR},
      {"HTTP", "GET / HTTP/1.1\r\n\r\n", Error::PROTOCOL_ERROR}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    TestClient client = server.connect();
    client.send_bytes(row.bytes);
    expect_refused(server, client, row.code);
  }
  EXPECT_EQ(server.service.opened(), 0u);
}

TEST_P(Misbehaviour, AfterTheHello) {
  TestServer server(test_config(), GetParam());
  const std::string more = beginning(GetParam());
  struct Row {
    const char* name;
    std::string bytes;
    Error::Code code;
  };
  Envelope composite;
  composite.mutable_composite();
  Envelope large_hello = hello_message();
  large_hello.mutable_hello()->set_token(std::string(protocol::kMaxControlBytes, 't'));
  const std::vector<Row> rows{
      {"second hello", encode(hello_message()), Error::UNEXPECTED_MESSAGE},
      {"a server's message", encode(composite), Error::UNEXPECTED_MESSAGE},
      {"unknown kind", length_prefix(3) + "\x7a\x01x", Error::UNKNOWN_MESSAGE},
      {"large control message", encode(large_hello), Error::PROTOCOL_ERROR},
      {"length 0", length_prefix(0), Error::PROTOCOL_ERROR},
      {"length above the limit", length_prefix(protocol::kMaxCameraFrameBytes + 1) + more,
       Error::PROTOCOL_ERROR},
      {"the renderer fails", encode(frame_message(1, kCrashJpeg)), Error::INTERNAL}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    TestClient client = server.session();
    client.send_bytes(row.bytes);
    expect_refused(server, client, row.code);
  }
}

TEST_P(Misbehaviour, InternalErrorsKeepTheirDetailsToTheLog) {
  TestServer server(test_config(), GetParam());
  TestClient client = server.session();
  client.send(frame_message(1, kCrashJpeg));
  EXPECT_EQ(client.expect_error(Error::INTERNAL).text().find("secret"), std::string::npos);
}

TEST_P(Misbehaviour, TheErrorArrivesEvenIfTheClientKeepsSending) {
  TestServer server(test_config(), GetParam());
  TestClient client = server.session();
  client.send_bytes(length_prefix(protocol::kMaxCameraFrameBytes + 1));
  // Without reading to the end, the server's close would reset the connection under these bytes.
  client.send_bytes(std::string(1'000'000, 'x'));
  client.expect_error(Error::PROTOCOL_ERROR);
}

TEST_P(Misbehaviour, WrongOrMissingTokensAreRefused) {
  net::ServerConfig config = test_config();
  config.grants = {{"opensesame", {.view = true, .environment = true}}};
  TestServer server(config, GetParam());
  for (const std::string token : {"", "opensesamf", "opensesam", "opensesame "}) {
    TestClient client = server.connect();
    Envelope hello = hello_message();
    hello.mutable_hello()->set_token(token);
    client.send(hello);
    expect_refused(server, client, Error::AUTH_FAILED);
  }
  EXPECT_EQ(server.service.opened(), 0u);
}

TEST_P(Misbehaviour, AStreamCutAtAnyByteHarmsNobody) {
  net::ServerConfig config = test_config();
  TestServer server(config, GetParam());
  TestClient healthy = server.session();
  Envelope frame = frame_message(1);
  add_pose(frame, 40);
  const std::string stream = encode(hello_message()) + encode(frame);
  for (std::size_t size = 0; size <= stream.size(); ++size) {
    TestClient cut = server.connect();
    cut.send_bytes(std::string_view(stream).substr(0, size));
    cut.finish_sending();
    while (cut.receive()) {
    }
  }
  healthy.send(frame_message(1));
  healthy.expect(Envelope::kComposite);
  EXPECT_TRUE(server.service.wait_views(1));
}

TEST_P(Misbehaviour, ConnectionsAboveACapAreRefusedAndMayComeBack) {
  net::ServerConfig config = test_config();
  config.connections.per_address = 2;
  TestServer server(config, GetParam());
  std::vector<TestClient> clients;
  clients.push_back(server.session());
  clients.push_back(server.session());
  if (GetParam() == Over::WebSocket) {
    // Refused before it has asked for a session, so in HTTP.
    const HttpAnswer answer = http_exchange(server.address(), "");
    EXPECT_EQ(answer.status, 503);
    EXPECT_NE(answer.head.find("Retry-After: 2"), std::string::npos) << answer.head;
  } else {
    TestClient refused = server.connect();
    EXPECT_GT(refused.expect(Envelope::kBusy).busy().retry_after_ms(), 0u);
    EXPECT_TRUE(refused.closed_by_server());
  }
  EXPECT_EQ(server.service.opened(), 2u);
  clients.clear();
  ASSERT_TRUE(server.service.wait_views(0));
  server.session();
}

INSTANTIATE_TEST_SUITE_P(Over, Misbehaviour, kEachTransport, transport_name);

}  // namespace
}  // namespace amalgam::test
