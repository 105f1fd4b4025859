// Servers that break the protocol: the client gives up, and neither crashes nor fills its memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>

#include "client/link/connection.h"
#include "client/link/messages.h"
#include "unit/client/link/fake_server.h"

namespace amalgam::client {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

protocol::Hello hello() {
  return hello_message(common::default_camera(64, 48), "", 0);
}

std::string frame(std::uint64_t id) {
  return protocol::encode(frame_message(id, std::vector<unsigned char>(10, 'x'), {}, {}));
}

template <typename Event>
bool is(const std::optional<ConnectionEvent>& event) {
  return event && std::holds_alternative<Event>(*event);
}

std::string why_given_up(const std::optional<ConnectionEvent>& event) {
  return is<GaveUp>(event) ? std::get<GaveUp>(*event).text : "not given up";
}

protocol::Envelope composite_of(std::uint64_t id) {
  protocol::Envelope envelope;
  envelope.mutable_composite()->set_frame_id(id);
  envelope.mutable_composite()->set_jpeg("unasked");
  return envelope;
}

// A CameraFrame of 65 empty poses, which the decoder reports and does not keep.
TEST(HostileServer, APoseBombIsRefused) {
  FakeServer server({[](FakePeer& peer) {
    peer.receive();
    std::string bomb("\x85\0\0\0\x12\x82\x01", 7);
    for (int i = 0; i < 65; ++i) bomb += std::string("\x1a\0", 2);
    peer.send_bytes(bomb);
    peer.receive();
  }});
  Connection connection(server.options(3000ms), hello());
  EXPECT_THAT(why_given_up(connection.wait(3000ms)),
              HasSubstr("sent a message that servers do not send"));
}

// Nothing is reconnected then, and nothing says so.
TEST(HostileServer, AfterAWelcomeItsRefusalIsTheEndAtOnce) {
  FakeServer server({[](FakePeer& peer) {
    peer.welcome();
    peer.receive();
    protocol::Envelope second;
    second.mutable_welcome();
    peer.send(second);
    peer.receive();
  }});
  Connection connection(server.options(3000ms), hello());
  ASSERT_TRUE(is<Welcomed>(connection.wait(3000ms)));
  connection.send(1, frame(1));
  EXPECT_THAT(why_given_up(connection.wait(3000ms)), HasSubstr("a second welcome"));
}

TEST(HostileServer, ItsUnaskedCompositesAreNotKept) {
  FakeServer server({[](FakePeer& peer) {
    peer.welcome();
    const auto first = peer.receive();
    ASSERT_TRUE(first);
    for (const std::uint64_t id : {0, 2, 3, 1000}) peer.send(composite_of(id));
    peer.answer(first->camera_frame());
    peer.answer(first->camera_frame());
    const auto second = peer.receive();
    ASSERT_TRUE(second);
    peer.answer(first->camera_frame());
    peer.answer(second->camera_frame());
    peer.receive();
  }});
  Connection connection(server.options(3000ms), hello());
  ASSERT_TRUE(is<Welcomed>(connection.wait(3000ms)));
  for (std::uint64_t id = 1; id <= 2; ++id) {
    connection.send(id, frame(id));
    const auto event = connection.wait(3000ms);
    ASSERT_TRUE(is<Composited>(event)) << id;
    EXPECT_EQ(std::get<Composited>(*event).composite.frame_id(), id);
    EXPECT_EQ(std::get<Composited>(*event).composite.jpeg(), "xxxxxxxxxx");
  }
  EXPECT_FALSE(connection.wait(50ms));
}

TEST(HostileServer, OfAFloodOfErrorsSomeAreKept) {
  std::promise<void> sent;
  FakeServer server({[&](FakePeer& peer) {
    peer.welcome();
    protocol::Envelope error;
    error.mutable_error()->set_code(protocol::Error::BAD_IMAGE);
    for (int i = 0; i < 1000; ++i) peer.send(error);
    peer.wait_for_pong();
    sent.set_value();
    peer.answer_frames();
  }});
  Connection connection(server.options(3000ms), hello());
  sent.get_future().wait();
  int errors = 0;
  ASSERT_TRUE(is<Welcomed>(connection.wait(3000ms)));
  while (is<FrameError>(connection.wait(10ms))) ++errors;
  EXPECT_GE(errors, 10);
  EXPECT_LE(errors, 100);
  // And the session goes on.
  connection.send(1, frame(1));
  EXPECT_TRUE(is<Composited>(connection.wait(3000ms)));
}

}  // namespace
}  // namespace amalgam::client
