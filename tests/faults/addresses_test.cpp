// Rows 3, 38 and 42: places are counted by who owns an address.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "faults/control_client.h"
#include "faults/figure.h"
#include "net/address_key.h"
#include "net/connection_limits.h"
#include "support/net/test_server.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;

// The attacker's thousand descriptors are in the server's own process, which usually may have 1024.
// The kernel's table of them grows by doubling, and who opens one meanwhile waits 10 ms and more,
// so it grows now.
void make_room_for_descriptors(rlim_t count) {
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &limit), 0);
  limit.rlim_cur = std::min(std::max(limit.rlim_cur, count), limit.rlim_max);
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &limit), 0);
  const int highest = ::fcntl(STDERR_FILENO, F_DUPFD, static_cast<int>(count) - 1);
  ASSERT_GE(highest, 0) << "the limit of descriptors is " << limit.rlim_max;
  ::close(highest);
}

TEST(Addresses, AThousandHalfOpenSocketsFromOneAddress) {
  make_room_for_descriptors(2000);
  TestServer server;
  const ControlClient::Felt alone = ControlClient::feel_alone(server.server().address());
  ControlClient control(server.server().address());
  std::vector<TestClient> sockets;
  for (int i = 0; i < 1000; ++i) {
    sockets.push_back(server.connect());
    std::this_thread::sleep_for(std::chrono::microseconds(200));  // see ControlClient
  }
  std::size_t refused = 0;
  for (std::size_t i = 100; i < 200; ++i) {
    if (sockets[i].receive().value_or(Envelope()).has_busy()) ++refused;
  }
  EXPECT_EQ(refused, 100u);
  EXPECT_EQ(server.service.opened(), 2u) << "the control clients'";
  expect_unharmed("3", alone, control.end());
}

// A PROXY header, version 2, of a TCP connection from this IPv4 address.
std::string proxy_header(unsigned char last_byte) {
  std::string header("\r\n\r\n\0\r\nQUIT\n\x21\x11\0\x0c", 16);
  header += std::string("\x0a\x00\x00", 3) + static_cast<char>(last_byte);
  header += std::string("\x7f\x00\x00\x01\x30\x39\x1d\x17", 8);
  return header;
}

net::ServerConfig behind_a_proxy() {
  net::ServerConfig config = test_config();
  config.trusted_proxies = {"127.0.0.1"};
  config.connections.per_address = 2;
  return config;
}

TEST(Addresses, ClientsBehindAProxyAreCountedApart) {
  TestServer server(behind_a_proxy());
  std::vector<TestClient> clients;
  for (unsigned char address = 1; address <= 4; ++address) {
    for (int i = 0; i < 2; ++i) {
      clients.push_back(server.connect());
      clients.back().send_bytes(proxy_header(address));
      clients.back().send(hello_message());
      clients.back().expect(Envelope::kWelcome);
    }
  }
  TestClient third = server.connect();
  third.send_bytes(proxy_header(1));
  third.send(hello_message());
  EXPECT_TRUE(third.receive().value_or(Envelope()).has_busy());
  EXPECT_THAT(server.admin("/state").body, testing::HasSubstr("10.0.0.4:12345"));
  print_figure("42", "clients from one proxy", static_cast<double>(clients.size()), "",
               "as many as addresses allow");
}

TEST(Addresses, BrowsersBehindAProxyAreCountedApart) {
  TestServer server(behind_a_proxy(), Over::WebSocket);
  std::vector<TestClient> clients;
  for (unsigned char address = 1; address <= 4; ++address) {
    for (int i = 0; i < 2; ++i) {
      clients.emplace_back(server.address(), 0, Over::WebSocket, proxy_header(address));
      clients.back().send(hello_message());
      clients.back().expect(Envelope::kWelcome);
    }
  }
  TestClient third(server.address(), 0, Over::WebSocket, proxy_header(1));
  EXPECT_TRUE(third.receive().value_or(Envelope()).has_busy());
  EXPECT_THAT(server.admin("/state").body, testing::HasSubstr("10.0.0.4:12345"));
}

TEST(Addresses, AProxysHeaderMustBeOneAndMayComeSlowly) {
  TestServer server(behind_a_proxy());
  TestClient none = server.connect();
  none.send(hello_message());
  none.expect_error(protocol::Error::PROTOCOL_ERROR);
  TestClient slow = server.connect();
  for (const char byte : proxy_header(9)) slow.send_bytes(std::string(1, byte));
  slow.send(hello_message());
  slow.expect(Envelope::kWelcome);
}

// Whoever is not trusted cannot pretend to be somebody else.
TEST(Addresses, StrangersSendNoProxyHeader) {
  TestServer server;
  TestClient client = server.connect();
  client.send_bytes(proxy_header(1));
  client.expect_error(protocol::Error::PROTOCOL_ERROR);
}

TEST(Addresses, AnIPv6NetworkIsOneAddress) {
  const auto key = [](const char* text) {
    return net::address_key(boost::asio::ip::make_address(text));
  };
  EXPECT_EQ(key("2001:db8:1:2::1"), key("2001:db8:1:2:ffff::9"));
  EXPECT_NE(key("2001:db8:1:2::1"), key("2001:db8:1:3::1"));
  EXPECT_EQ(key("::ffff:10.0.0.1"), key("10.0.0.1"));
  EXPECT_NE(key("10.0.0.1"), key("10.0.0.2"));
}

TEST(Addresses, StrangersLeaveRoomForWhoWasLetInBefore) {
  net::ServerConfig config = test_config();
  config.connections.unauthenticated = 4;
  TestServer server(config);
  server.session();  // and it leaves again
  std::vector<TestClient> half_open;
  half_open.reserve(4);
  for (int i = 0; i < 4; ++i) half_open.push_back(server.connect());
  HttpAnswer ready;
  for (int i = 0; i < 500 && ready.status != 503; ++i) {  // until they are accepted
    ready = server.admin("/readyz");
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(ready.status, 503);
  EXPECT_EQ(ready.body, "too many connections without a hello\n");
  TestClient known = server.session();
  // An address that nobody was let in from.
  net::ConnectionLimits limits(config.connections);
  std::vector<net::ConnectionLimits::Ticket> tickets;
  for (const char* address : {"a", "b", "c", "d"}) {
    tickets.push_back(std::get<net::ConnectionLimits::Ticket>(limits.admit(address)));
  }
  EXPECT_EQ(std::get<net::ConnectionLimits::Refusal>(limits.admit("e")),
            net::ConnectionLimits::Refusal::Unauthenticated);
}

}  // namespace
}  // namespace amalgam::test
