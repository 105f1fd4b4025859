// TLS 1.3: clients trust the right certificate and no other, and reloading it harms no session.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <string>

#include "client/link/connection.h"
#include "client/link/messages.h"
#include "client/tracking/calibration.h"
#include "faults/figure.h"
#include "net/back_off.h"
#include "protocol/client_tls.h"
#include "support/net/test_server.h"
#include "support/net/web_wire.h"

namespace amalgam::test {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

class Tls : public testing::Test {
 protected:
  Tls() : folder_(fs::temp_directory_path() / ("amalgam-tls-" + std::to_string(::getpid()))) {
    make_certificate("a");
    config_.tls = files("a");
    config_.session.hello_timeout = milliseconds(500);
  }
  ~Tls() override { fs::remove_all(folder_); }

  void make_certificate(const std::string& name) const {
    const std::string command = "deploy/make_test_certificate.sh " + (folder_ / name).string();
    EXPECT_EQ(std::system(command.c_str()), 0);
  }
  net::TlsFiles files(const std::string& name) const {
    return {folder_ / name / "server.crt", folder_ / name / "server.key"};
  }
  client::ConnectionOptions options(TestServer& server, const std::string& trusted,
                                    const std::string& host = "127.0.0.1") const {
    return {.server = {host, server.server().address().port},
            .connect_timeout = milliseconds(5000),
            .tls = true,
            .certificate_authority = folder_ / trusted / "server.crt"};
  }

  fs::path folder_;
  net::ServerConfig config_ = test_config();
};

std::string frame(std::uint64_t id, std::size_t bytes) {
  return protocol::encode(
      client::frame_message(id, std::vector<unsigned char>(bytes, 'j'), {}, {}));
}

// Sends a frame when welcomed; true if its composite comes back.
bool exchange(client::Connection& connection, std::uint64_t id, std::string* error = nullptr) {
  bool sent = false;
  for (;;) {
    auto event = connection.wait(milliseconds(10'000));
    if (!event) return false;
    if (std::holds_alternative<client::Welcomed>(*event)) {
      connection.send(id, frame(id, 100'000));
      sent = true;
    }
    if (const auto* up = std::get_if<client::GaveUp>(&*event)) {
      if (error != nullptr) *error = up->text;
      return false;
    }
    if (const auto* composited = std::get_if<client::Composited>(&*event)) {
      return sent && composited->composite.frame_id() == id &&
             composited->composite.jpeg().size() == 100'000;
    }
  }
}

protocol::Hello hello() {
  return client::hello_message(common::default_camera(64, 48), "", 0);
}

// A handshake costs the server a signature, so failed ones count as wrong tokens do. Who only looks
// whether somebody is there, as a balancer does every second, fails at nothing.
TEST_F(Tls, FailedHandshakesSlowTheirAddressDown) {
  TestServer server(config_);
  const auto is_served = [&] {
    client::ConnectionOptions once = options(server, "a");
    once.connect_timeout = milliseconds(300);
    client::Connection connection(once, hello());
    return exchange(connection, 1);
  };
  for (int i = 0; i < 20; ++i) server.connect();
  EXPECT_TRUE(is_served()) << "after 20 connections that said nothing";
  for (int i = 0; i < net::BackOff::kFree + 1; ++i) {
    TestClient client = server.connect();
    client.send_bytes("GET / HTTP/1.0\r\n\r\n");
    EXPECT_FALSE(client.is_open()) << "an alert, perhaps, and the end";
  }
  EXPECT_FALSE(is_served());
  const std::string metrics = server.admin("/metrics").body;
  EXPECT_EQ(metrics.find("reason=\"back_off\"} 0"), std::string::npos) << "not refused for that";
}

TEST_F(Tls, FramesGoThroughItAndStrangersAreNotTrusted) {
  make_certificate("b");
  TestServer server(config_);
  {
    const auto begin = std::chrono::steady_clock::now();
    client::Connection connection(options(server, "a"), hello());
    EXPECT_TRUE(exchange(connection, 1));
    print_figure(
        "TLS", "handshake, hello and a frame of 100 kB took",
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count(),
        "ms", "-");
  }
  std::string error;
  client::Connection distrusts(options(server, "b"), hello());
  EXPECT_FALSE(exchange(distrusts, 1, &error));
  EXPECT_NE(error.find("verify failed"), std::string::npos) << error;
}

TEST_F(Tls, TheCertificateMustBeTheHosts) {
  net::ServerConfig elsewhere = config_;
  elsewhere.listen.host = "127.0.0.2";  // not in the certificate
  TestServer other(elsewhere);
  std::string error;
  client::Connection other_name(options(other, "a", "127.0.0.2"), hello());
  EXPECT_FALSE(exchange(other_name, 1, &error));
  EXPECT_NE(error.find("verify failed"), std::string::npos) << error;
  TestServer server(config_);
  client::Connection by_name(options(server, "a", "localhost"), hello());
  EXPECT_TRUE(exchange(by_name, 1));
}

TEST_F(Tls, WhoDoesNotEncryptGetsNothing) {
  TestServer server(config_);
  TestClient plain = server.connect();
  plain.send(hello_message());
  EXPECT_EQ(server.service.opened(), 0u);
  // The handshake has the hello's time: who never begins it is closed without a word in clear.
  TestClient silent = server.connect();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(silent.closed_by_server());
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  print_figure("1", "a handshake that never begins ends after", seconds, "s",
               "hello time-out (here .5 s) and linger (1 s)");
  EXPECT_GE(seconds, 0.4);
  EXPECT_LT(seconds, 6.0);
}

TEST_F(Tls, ANewCertificateIsForNewConnections) {
  make_certificate("b");
  TestServer server(config_);
  client::Connection old(options(server, "a"), hello());
  EXPECT_TRUE(exchange(old, 1));
  net::ServerConfig changed = config_;
  changed.tls = files("b");
  std::promise<bool> configured;
  server.server().post([&] {
    // A bad one leaves everything as it was.
    net::ServerConfig bad = config_;
    bad.tls.key = "/nonexistent.key";
    EXPECT_THROW(net::make_tls_context(bad.tls), std::runtime_error);
    server.server().configure(changed, net::make_tls_context(changed.tls));
    configured.set_value(true);
  });
  configured.get_future().wait();
  client::Connection fresh(options(server, "b"), hello());
  EXPECT_TRUE(exchange(fresh, 1));
  old.send(2, frame(2, 100'000));
  const auto event = old.wait(milliseconds(10'000));
  ASSERT_TRUE(event);
  EXPECT_TRUE(std::holds_alternative<client::Composited>(*event));
}

TEST_F(Tls, BrowsersGetPageAndSessionThroughIt) {
  TestServer server(config_, Over::WebSocket);
  TestClient socket(server.address());
  WebWire wire(socket.handle(), server.address(), "https://" + to_string(server.address()),
               protocol::client_tls((folder_ / "a" / "server.crt").string()));
  wire.write(hello_message().SerializeAsString());
  for (std::uint64_t id = 1; id <= 3; ++id) {
    wire.write(frame_message(id, std::string(100'000, 'j')).SerializeAsString());
  }
  protocol::Envelope envelope;
  std::uint64_t last = 0;
  bool welcomed = false;
  while (last != 3) {
    const std::optional<std::string> message = wire.read();
    ASSERT_TRUE(message);
    ASSERT_TRUE(envelope.ParseFromString(*message));
    welcomed = welcomed || envelope.has_welcome();
    if (envelope.has_ping()) {  // a composite was read; the third waits for that
      protocol::Envelope pong;
      pong.mutable_pong()->set_nonce(envelope.ping().nonce());
      ASSERT_TRUE(wire.write(pong.SerializeAsString()));
    }
    if (!envelope.has_composite()) continue;
    EXPECT_EQ(envelope.composite().jpeg().size(), 100'000u);
    last = envelope.composite().frame_id();
  }
  EXPECT_TRUE(welcomed);
  // In clear there is neither a page nor a session.
  EXPECT_EQ(http_get(server.address(), "/").status, 0);
}

TEST_F(Tls, FilesThatDoNotBelongTogetherAreRefusedAtStart) {
  make_certificate("b");
  net::ServerConfig config = config_;
  config.tls.key = files("b").key;
  EXPECT_THROW(net::Server{config}, std::runtime_error);
  config.tls.key = "";
  EXPECT_THROW(net::Server{config}, std::runtime_error);
}

}  // namespace
}  // namespace amalgam::test
