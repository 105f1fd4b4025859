// Records of sessions where there is no room for them: nobody notices, but whoever looks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "faults/control_client.h"
#include "support/net/each_transport.h"
#include "support/record_folder.h"

namespace amalgam::test {
namespace {

using protocol::Envelope;

class Records : public EachTransport {
 protected:
  net::ServerConfig recording() const {
    net::ServerConfig config = test_config();
    config.record.folder = folder_.path();
    return config;
  }
  RecordFolder folder_;
};

nlohmann::json state_of(TestServer& server) {
  return nlohmann::json::parse(server.admin("/state").body);
}

// Waits until so many records have ended.
bool wait_ended(TestServer& server, int count) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (std::chrono::steady_clock::now() < end) {
    const auto records = state_of(server)["records"];
    if (records["begun"].get<int>() - records["open"].get<int>() >= count) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

TEST_P(Records, AFullRecordEndsAndItsSessionGoesOn) {
  net::ServerConfig config = recording();
  config.record.session_bytes = 200'000;
  TestServer server(config, GetParam());
  ControlClient control(server.server().address());
  TestClient client = server.session();
  const std::string jpeg(50'000, 'j');
  for (std::uint64_t id = 1; id <= 20; ++id) {
    client.send(frame_message(id, jpeg));
    client.expect(Envelope::kComposite);
  }
  const auto state = state_of(server);
  EXPECT_EQ(state["records"]["full"], 1);
  EXPECT_EQ(state["records"]["open"], 1);
  EXPECT_EQ(state["sessions"][0]["record"], "on");
  EXPECT_EQ(state["sessions"][1]["record"], "full");
  EXPECT_GT(state["sessions"][1]["record_bytes"], 100'000);
  EXPECT_LE(state["sessions"][1]["record_bytes"], 200'000);
  EXPECT_GE(state["records"]["bytes_written"], state["sessions"][1]["record_bytes"]);
  EXPECT_THAT(server.admin("/metrics").body,
              testing::HasSubstr("amalgam_records_ended_total{reason=\"full\"} 1"));
  const auto felt = control.end();
  EXPECT_FALSE(felt.lost);
  EXPECT_GT(felt.frames, 0u);
}

// The folder goes while a session is recorded, and another one begins.
TEST_P(Records, AFolderThatGoesEndsNoSession) {
  TestServer server(recording(), GetParam());
  ControlClient control(server.server().address());
  // The control client's record has begun, or it would fail too.
  for (int i = 0; i < 1000 && std::filesystem::is_empty(folder_.path()); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  std::filesystem::remove_all(folder_.path());
  {
    TestClient client = server.session();
    client.send(frame_message(1));
    client.expect(Envelope::kComposite);
    ASSERT_TRUE(wait_ended(server, 1));
    EXPECT_EQ(state_of(server)["records"]["failed"], 1);
    EXPECT_EQ(state_of(server)["sessions"][1]["record"], "failed");
    client.send(frame_message(2));
    client.expect(Envelope::kComposite);
  }
  EXPECT_FALSE(control.end().lost);
}

// Both transports end in the same place.
TEST_P(Records, HasWhatWentBothWays) {
  {
    TestServer server(recording(), GetParam());
    TestClient client = server.session();
    Envelope ping;
    ping.mutable_ping()->set_nonce(5);
    client.send(ping);
    client.expect(Envelope::kPong);
    client.send(frame_message(7, "picture"));
    client.expect(Envelope::kComposite);
    client.send(frame_message(8, kBadJpeg));
    client.expect_error(protocol::Error::BAD_IMAGE);
    Envelope goodbye;
    goodbye.mutable_goodbye();
    client.send(goodbye);
    client.closed_by_server();
  }
  std::vector<std::string> said;
  for (const auto& record : RecordFolder::read(folder_.closed(1).at(0))) {
    using protocol::SessionRecord;
    const auto name = [](const Envelope& envelope) { return std::to_string(envelope.body_case()); };
    switch (record.event_case()) {
      case SessionRecord::kReceived:
        if (!record.received().envelope().has_pong()) {
          said.push_back("got " + name(record.received().envelope()));
        }
        break;
      case SessionRecord::kSent:
        said.push_back("said " + name(record.sent()));
        break;
      case SessionRecord::kSubmitted:
        said.push_back("frame " + std::to_string(record.submitted().frame()));
        break;
      case SessionRecord::kRendered:
        said.push_back(record.rendered().has_error() ? "failed" : "rendered");
        break;
      case SessionRecord::kWritten:
        said.push_back("written " + std::to_string(record.written().frame()));
        break;
      default:
        said.push_back("end");
    }
  }
  const auto got = [](int body) { return "got " + std::to_string(body); };
  const auto tells = [](int body) { return "said " + std::to_string(body); };
  EXPECT_EQ(said, (std::vector<std::string>{
                      tells(Envelope::kWelcome), tells(Envelope::kPing), got(Envelope::kPing),
                      tells(Envelope::kPong), got(Envelope::kCameraFrame), "frame 1", "rendered",
                      "written 1", tells(Envelope::kPing), got(Envelope::kCameraFrame), "frame 2",
                      "failed", tells(Envelope::kError), got(Envelope::kGoodbye), "end"}));
}

INSTANTIATE_TEST_SUITE_P(Over, Records, kEachTransport, transport_name);

}  // namespace
}  // namespace amalgam::test
