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

class TestServer {
 public:
  explicit TestServer(const net::ServerConfig& config = test_config()) : server_(config) {
    server_.serve(service);
  }
  ~TestServer() {
    server_.stop();
    if (thread_.joinable()) thread_.join();
  }

  TestClient connect(int receive_buffer = 0) {
    return TestClient(server_.address(), receive_buffer);
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
  net::Server server_;
  std::thread thread_{[this] { server_.run(); }};
};

}  // namespace amalgam::test
