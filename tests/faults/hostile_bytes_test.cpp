// Rows 4, 32 and 33: bytes that should cost the server nothing.
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "faults/control_client.h"
#include "faults/figure.h"
#include "net/process_figures.h"
#include "protocol/limits.h"
#include "support/net/each_transport.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;
using protocol::Error;
using Clock = std::chrono::steady_clock;

class HostileBytes : public EachTransport {};

std::string with_length(const std::string& body) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>((body.size() >> (8 * i)) & 0xff));
  return bytes + body;
}

std::string varint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7) bytes.push_back(static_cast<char>((value & 0x7f) | 0x80));
  bytes.push_back(static_cast<char>(value));
  return bytes;
}

// Frame 7 with so many empty poses, two bytes each on the wire and a hundred once parsed.
std::string pose_bomb(std::size_t poses) {
  std::string frame = "\x08\x07";
  for (std::size_t i = 0; i < poses; ++i) frame += std::string("\x1a\x00", 2);
  return with_length("\x12" + varint(frame.size()) + frame);
}

double resident_mib() {
  return static_cast<double>(net::read_process_figures().resident_bytes) / (1024.0 * 1024.0);
}

TEST_P(HostileBytes, APoseBombIsNeitherKeptNorParsed) {
  TestServer server(test_config(), GetParam());
  const ControlClient::Felt alone = ControlClient::feel_alone(server.server().address());
  ControlClient control(server.server().address());
  TestClient bomber = server.session();
  const std::string bomb = bomber.on_the_wire(pose_bomb(2'000'000));
  const double before = resident_mib();
  double most = before, slowest_ms = 0.0;
  for (int i = 0; i < 10; ++i) {
    const auto begin = Clock::now();
    bomber.send_raw(bomb);
    const Error error = bomber.expect_error(Error::TOO_MANY_POSES);
    slowest_ms = std::max(slowest_ms,
                          std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    EXPECT_EQ(error.frame_id(), 7u);
    EXPECT_FALSE(error.closes());
    most = std::max(most, resident_mib());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // see ControlClient
  }
  bomber.send(frame_message(8));  // the session goes on behind it
  EXPECT_EQ(bomber.expect(Envelope::kComposite).composite().skipped(), 10u);
  const ControlClient::Felt felt = control.end();
  print_figure("32", "memory grew by", most - before, "MiB", "below 64 KiB a bomb");
  print_figure("32", "a bomb of 4 MiB takes", slowest_ms, "ms", "-");
  // Of ten bombs of 4 MiB, which parsed would be 117 MiB each.
  EXPECT_LT(most - before, 4.0);
  expect_unharmed("32", alone, felt, 5.0);
}

TEST_P(HostileBytes, PosesAndCornersAreCountedTogether) {
  TestServer server(test_config(), GetParam());
  TestClient client = server.session();
  for (const int corners : {24, 25}) {
    Envelope frame = frame_message(static_cast<std::uint64_t>(corners));
    for (int i = 0; i < 40; ++i) add_pose(frame, i);
    for (int i = 0; i < corners; ++i) frame.mutable_camera_frame()->add_corners()->set_marker(i);
    client.send(frame);
    // 64 are looked at, and found to have no corners.
    client.expect_error(corners == 24 ? Error::POSE_REJECTED : Error::TOO_MANY_POSES);
    if (corners == 24) client.expect(Envelope::kComposite);
  }
}

TEST_P(HostileBytes, WhatServersSendIsSmallWhenAClientSendsIt) {
  TestServer server(test_config(), GetParam());
  for (const char tag : {'\x42', '\x3a', '\x52'}) {  // Composite, Welcome, Error
    TestClient client = server.session();
    const std::string body = std::string(1, tag) + varint(1'000'000) + std::string(100, 'x');
    // The length says a megabyte; it is refused with the first byte behind that.
    client.send_bytes(with_length(std::string(1'000'004, 'x')).substr(0, 4) + body.substr(0, 1));
    client.expect_error(Error::PROTOCOL_ERROR);
  }
}

TEST_P(HostileBytes, OnlyImagesAreLarge) {
  TestServer server(test_config(), GetParam());
  TestClient client = server.session();
  // An unknown field of a frame, before any image.
  const std::string frame = "\x7a" + varint(1'000'000) + std::string(1'000'000, 'x');
  client.send_bytes(with_length("\x12" + varint(frame.size()) + frame));
  client.expect_error(Error::PROTOCOL_ERROR);
}

TEST_P(HostileBytes, AnEnvelopeHasOneBody) {
  TestServer server(test_config(), GetParam());
  Envelope ping;
  ping.mutable_ping()->set_nonce(1);
  const std::string two = frame_message(1).SerializeAsString() + ping.SerializeAsString();
  TestClient client = server.session();
  client.send_bytes(with_length(two));
  client.expect_error(Error::PROTOCOL_ERROR);
  // The same one twice is two as well: Protocol Buffers would merge them.
  TestClient again = server.session();
  again.send_bytes(with_length(ping.SerializeAsString() + ping.SerializeAsString()));
  again.expect_error(Error::PROTOCOL_ERROR);
}

TEST_P(HostileBytes, LengthsAllocateNothing) {
  TestServer server(test_config(), GetParam());
  std::vector<TestClient> clients;
  clients.reserve(12);
  for (int i = 0; i < 12; ++i) clients.push_back(server.session());
  const double before = resident_mib();
  for (TestClient& client : clients) {
    // Four megabytes of a frame are announced, and one byte comes.
    client.send_bytes(std::string("\x00\x00\x40\x00\x12", 5));
  }
  server.admin("/livez");  // so the server has read them
  const double grown = resident_mib() - before;
  print_figure("4", "memory for 12 announced frames grew by", grown, "MiB", "below 64 KiB each");
  EXPECT_LT(grown, 4.0);
}

INSTANTIATE_TEST_SUITE_P(Over, HostileBytes, kEachTransport, transport_name);

}  // namespace
}  // namespace amalgam::test
