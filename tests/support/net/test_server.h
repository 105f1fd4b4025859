// A real server on a free loopback port with a stub behind it, for the length of a test.
#pragma once

#include <thread>

#include "net/server.h"
#include "support/net/stub_frame_service.h"
#include "support/net/test_client.h"

namespace amalgam::test {

inline net::ServerConfig test_config() {
  net::ServerConfig config;
  config.listen.port = 0;
  config.admin.port = 0;
  return config;
}

inline net::ServerConfig with_web(net::ServerConfig config) {
  config.web = common::HostPort{"127.0.0.1", 0};
  return config;
}

class TestServer {
 public:
  // over: how connect() and session() reach it.
  explicit TestServer(const net::ServerConfig& config = test_config(), Over over = Over::Tcp)
      : over_(over), server_(over == Over::WebSocket ? with_web(config) : config) {
    server_.serve(service);
  }
  ~TestServer() {
    server_.stop();
    if (thread_.joinable()) thread_.join();
  }

  TestClient connect(int receive_buffer = 0) {
    return TestClient(address(), receive_buffer, over_);
  }
  // Where its transport is spoken.
  common::HostPort address() const {
    return over_ == Over::WebSocket ? server_.web_address().value() : server_.address();
  }
  // Past its hello.
  TestClient session() {
    TestClient client = connect();
    client.send(hello_message());
    client.expect(protocol::Envelope::kWelcome);
    return client;
  }
  HttpAnswer admin(const std::string& path) { return http_get(server_.admin_address(), path); }
  net::Server& server() { return server_; }
  // Waits for the server to end by itself.
  void join() { thread_.join(); }

  StubFrameService service;

 private:
  Over over_;
  net::Server server_;
  std::thread thread_{[this] { server_.run(); }};
};

}  // namespace amalgam::test
