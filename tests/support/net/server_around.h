// A real server on a free loopback port around any renderer, for the length of a test.
#pragma once

#include <string>
#include <thread>

#include "net/server.h"
#include "support/net/test_client.h"

namespace amalgam::test {

class ServerAround {
 public:
  // The service outlives it. The config's ports do not count.
  explicit ServerAround(frame::FrameService& service, const net::ServerConfig& config = {})
      : server_(with_free_ports(config)) {
    server_.serve(service);
  }
  ~ServerAround() {
    server_.stop();
    thread_.join();
  }

  common::HostPort address() const { return server_.address(); }
  HttpAnswer admin(const std::string& path) { return http_get(server_.admin_address(), path); }
  // Past its hello.
  TestClient session(const protocol::Envelope& hello = hello_message()) {
    TestClient client(server_.address());
    client.send(hello);
    client.expect(protocol::Envelope::kWelcome);
    return client;
  }

 private:
  static net::ServerConfig with_free_ports(net::ServerConfig config) {
    config.listen.port = config.admin.port = 0;
    return config;
  }

  net::Server server_;
  std::thread thread_{[this] { server_.run(); }};
};

}  // namespace amalgam::test
