#include "client/link/connection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <numeric>
#include <thread>

#include "client/link/messages.h"
#include "client/tracking/calibration.h"
#include "protocol/limits.h"
#include "unit/client/link/fake_server.h"

namespace amalgam::client {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

protocol::Hello hello() {
  return hello_message(common::default_camera(64, 48), "secret", 80);
}

std::string frame(std::uint64_t id, std::size_t bytes = 100) {
  return protocol::encode(frame_message(id, std::vector<unsigned char>(bytes, 'x'), {}, {}));
}

// The next event, which must be of this kind.
template <typename Event>
std::optional<Event> expect(Connection& connection, std::chrono::milliseconds within = 3000ms) {
  auto event = connection.wait(within);
  if (!event) {
    ADD_FAILURE() << "nothing happened in time";
    return std::nullopt;
  }
  if (!std::holds_alternative<Event>(*event)) {
    ADD_FAILURE() << "something else happened: alternative " << event->index();
    return std::nullopt;
  }
  return std::get<Event>(std::move(*event));
}

TEST(Connection, SaysHelloAndExchangesFrames) {
  std::optional<protocol::Hello> heard;
  FakeServer server({[&](FakePeer& peer) {
    heard = peer.welcome();
    peer.answer_frames();
  }});
  {
    Connection connection(server.options(3000ms), hello());
    const auto welcomed = expect<Welcomed>(connection);
    ASSERT_TRUE(welcomed);
    EXPECT_EQ(welcomed->welcome.markers().world_marker(), 40);
    for (std::uint64_t id = 1; id <= 3; ++id) {
      EXPECT_FALSE(connection.send(id, frame(id)));
      const auto composited = expect<Composited>(connection);
      ASSERT_TRUE(composited);
      EXPECT_EQ(composited->composite.frame_id(), id);
      EXPECT_EQ(composited->composite.jpeg(), std::string(100, 'x'));
    }
  }
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->version(), protocol::kProtocolVersion);
  EXPECT_EQ(heard->token(), "secret");
  EXPECT_EQ(heard->jpeg_quality(), 80u);
  EXPECT_EQ(heard->camera().width(), 64u);
}

TEST(Connection, AnswersPings) {
  std::promise<int> pongs;
  FakeServer server({[&](FakePeer& peer) {
    peer.welcome();
    protocol::Envelope ping;
    ping.mutable_ping()->set_nonce(5);
    for (int i = 0; i < 3; ++i) peer.send(ping);
    peer.answer_frames();
    pongs.set_value(peer.pongs);
  }});
  {
    Connection connection(server.options(3000ms), hello());
    ASSERT_TRUE(expect<Welcomed>(connection));
    connection.send(1, frame(1));
    EXPECT_TRUE(expect<Composited>(connection));
  }
  EXPECT_EQ(pongs.get_future().get(), 3);
}

TEST(Connection, NewestFrameWinsWhileNothingIsRead) {
  std::vector<std::uint64_t> arrived;
  std::promise<void> go;
  FakeServer server({[&](FakePeer& peer) {
    peer.welcome();
    go.get_future().wait();
    while (const auto message = peer.receive()) {
      if (!message->has_camera_frame()) break;
      arrived.push_back(message->camera_frame().frame_id());
      peer.answer(message->camera_frame());
    }
  }});
  std::vector<std::uint64_t> replaced;
  constexpr std::uint64_t kFrames = 40;
  {
    Connection connection(server.options(3000ms), hello());
    ASSERT_TRUE(expect<Welcomed>(connection));
    for (std::uint64_t id = 1; id <= kFrames; ++id) {
      if (const auto old = connection.send(id, frame(id, 1 << 20))) replaced.push_back(*old);
      std::this_thread::sleep_for(2ms);
    }
    go.set_value();
    std::uint64_t last = 0;
    while (last < kFrames) {
      const auto composited = expect<Composited>(connection);
      ASSERT_TRUE(composited);
      last = composited->composite.frame_id();
    }
  }
  EXPECT_GT(replaced.size(), kFrames / 2) << "frames were queued up";
  EXPECT_EQ(arrived.back(), kFrames);
  EXPECT_TRUE(std::ranges::is_sorted(arrived));
  // Each one either arrived or was given back.
  arrived.insert(arrived.end(), replaced.begin(), replaced.end());
  std::ranges::sort(arrived);
  std::vector<std::uint64_t> all(kFrames);
  std::iota(all.begin(), all.end(), 1u);
  EXPECT_EQ(arrived, all);
}

TEST(Connection, ReconnectsAndSendsWhatWaited) {
  FakeServer server({[](FakePeer& peer) {
                       peer.welcome();
                       peer.receive();  // takes a frame and dies
                     },
                     [](FakePeer& peer) {
                       peer.welcome();
                       peer.answer_frames();
                     }});
  Connection connection(server.options(3000ms), hello());
  ASSERT_TRUE(expect<Welcomed>(connection));
  connection.send(1, frame(1));
  const auto broken = expect<LinkBroken>(connection);
  ASSERT_TRUE(broken);
  EXPECT_EQ(broken->last_sent, 1u);
  connection.send(2, frame(2));
  ASSERT_TRUE(expect<Welcomed>(connection));
  const auto composited = expect<Composited>(connection);
  ASSERT_TRUE(composited);
  EXPECT_EQ(composited->composite.frame_id(), 2u);
}

TEST(Connection, WaitsWhenToldThatTheServerIsBusy) {
  FakeServer server({[](FakePeer& peer) {
                       peer.receive();
                       protocol::Envelope busy;
                       busy.mutable_busy()->set_retry_after_ms(300);
                       peer.send(busy);
                     },
                     [](FakePeer& peer) {
                       peer.welcome();
                       peer.answer_frames();
                     }});
  const auto start = std::chrono::steady_clock::now();
  Connection connection(server.options(3000ms), hello());
  ASSERT_TRUE(expect<Welcomed>(connection));
  EXPECT_GE(std::chrono::steady_clock::now() - start, 300ms);
}

TEST(Connection, DoesNotTryAgainWhenRefused) {
  FakeServer server({[](FakePeer& peer) {
    peer.receive();
    protocol::Envelope error;
    error.mutable_error()->set_code(protocol::Error::AUTH_FAILED);
    error.mutable_error()->set_text("the token is wrong");
    error.mutable_error()->set_closes(true);
    peer.send(error);
  }});
  Connection connection(server.options(10s), hello());
  const auto gave_up = expect<GaveUp>(connection, 2000ms);
  ASSERT_TRUE(gave_up);
  EXPECT_THAT(gave_up->text, HasSubstr("AUTH_FAILED: the token is wrong"));
}

TEST(Connection, HandsOnErrorsThatTheSessionSurvives) {
  FakeServer server({[](FakePeer& peer) {
    peer.welcome();
    peer.receive();
    protocol::Envelope error;
    error.mutable_error()->set_code(protocol::Error::BAD_IMAGE);
    error.mutable_error()->set_frame_id(1);
    peer.send(error);
    peer.answer_frames();
  }});
  Connection connection(server.options(3000ms), hello());
  ASSERT_TRUE(expect<Welcomed>(connection));
  connection.send(1, frame(1));
  const auto error = expect<FrameError>(connection);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->error.frame_id(), 1u);
  connection.send(2, frame(2));
  EXPECT_TRUE(expect<Composited>(connection));
}

TEST(Connection, SendsNoFramesToADrainingServer) {
  FakeServer server({[&](FakePeer& peer) {
                       peer.welcome();
                       protocol::Envelope draining;
                       draining.mutable_draining()->set_deadline_ms(1000);
                       peer.send(draining);
                       std::this_thread::sleep_for(200ms);  // then it closes
                     },
                     [&](FakePeer& peer) {
                       peer.welcome();
                       peer.answer_frames();
                     }});
  Connection connection(server.options(3000ms), hello());
  ASSERT_TRUE(expect<Welcomed>(connection));
  std::this_thread::sleep_for(100ms);
  connection.send(1, frame(1));
  const auto broken = expect<LinkBroken>(connection);
  ASSERT_TRUE(broken);
  EXPECT_EQ(broken->last_sent, 0u);
  ASSERT_TRUE(expect<Welcomed>(connection));
  EXPECT_TRUE(expect<Composited>(connection));
}

TEST(Connection, GivesUpWhereNobodyListens) {
  ConnectionOptions options;
  {
    // A port that was free a moment ago.
    boost::asio::io_context io;
    boost::asio::ip::tcp::acceptor acceptor(io, {boost::asio::ip::make_address("127.0.0.1"), 0});
    options.server.port = acceptor.local_endpoint().port();
  }
  options.connect_timeout = 300ms;
  Connection connection(options, hello());
  const auto gave_up = expect<GaveUp>(connection, 2000ms);
  ASSERT_TRUE(gave_up);
  EXPECT_THAT(gave_up->text, HasSubstr("refused"));
}

TEST(Connection, GivesUpOnAServerThatSaysNothing) {
  FakeServer server({[](FakePeer& peer) {
    while (peer.receive()) {
    }
  }});
  Connection connection(server.options(300ms), hello());
  EXPECT_TRUE(expect<GaveUp>(connection, 2000ms));
}

}  // namespace
}  // namespace amalgam::client
