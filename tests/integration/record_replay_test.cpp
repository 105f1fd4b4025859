// Sessions of a real server are recorded, and played again to another one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "client/tools/load/recorded_session.h"
#include "client/tools/load/run_replay.h"
#include "integration/real_server.h"
#include "protocol/framing.h"
#include "support/record_folder.h"
#include "tracking/square_pose.h"

namespace amalgam::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using protocol::Envelope;
using testing::HasSubstr;

// A client of a recorded session: frames that turn brighter, with the marker at many places.
class Filmer {
 public:
  Filmer(RealServer& server, int width, int height)
      : client_(session(server, width, height)), camera_(common::default_camera(width, height)) {}

  // Frames without poses are seen with the last one for a moment.
  Envelope next(bool with_pose = true) {
    const auto grey = static_cast<std::uint8_t>(60 + 7 * (++frames_ % 20));
    Envelope frame =
        frame_message(frames_, jpeg_of({camera_.width, camera_.height, common::Rgb8(grey)}));
    if (with_pose) *frame.mutable_camera_frame()->add_poses() = protocol::to_message(pose());
    return frame;
  }

  Envelope with_corners() {
    Envelope frame = next(false);
    protocol::MarkerCorners& corners = *frame.mutable_camera_frame()->add_corners();
    corners.set_marker(kMirrorWorldMarker);
    const auto projected = tracking::project_square(pose(), 0.05, camera_);
    for (const glm::dvec2& at : projected.value()) {
      corners.add_pixels(static_cast<float>(at.x));
      corners.add_pixels(static_cast<float>(at.y));
    }
    return frame;
  }

  void exchange(const Envelope& frame, Envelope::BodyCase answer = Envelope::kComposite) {
    client_.send(frame);
    client_.expect(answer);
  }

  // At once, so that all but the first and the last are skipped.
  void burst(int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i) bytes += protocol::encode(next());
    client_.send_bytes(bytes);
    while (client_.expect(Envelope::kComposite).composite().frame_id() < frames_) {
    }
  }

  TestClient& client() { return client_; }
  std::uint64_t frames() const { return frames_; }

 private:
  static TestClient session(RealServer& server, int width, int height) {
    Envelope hello = hello_message();
    *hello.mutable_hello()->mutable_camera() =
        protocol::to_message(common::default_camera(width, height));
    hello.mutable_hello()->mutable_smoothing()->set_min_cutoff(1.0);
    return server.server.session(hello);
  }

  common::MarkerPose pose() const {
    common::MarkerPose pose = frame::default_pose(kMirrorWorldMarker);
    pose.translation.x += 0.01 * static_cast<double>(frames_ % 5);
    return pose;
  }

  TestClient client_;
  common::CameraModel camera_;
  std::uint64_t frames_ = 0;
};

// Everything that decides a composite's bytes: light of one's own and of others, held, solved and
// missing poses, the exposure's memory, a camera that stands still, skipped and refused frames.
void play_everything(RealServer& server) {
  Filmer film(server, 96, 72), small(server, 64, 48);
  for (int i = 0; i < 3; ++i) {
    film.exchange(film.next());
    small.exchange(small.next());
  }
  send_light(film.client(), kCold, false);
  for (int i = 0; i < 3; ++i) film.exchange(film.next());
  for (int i = 0; i < 3; ++i) small.exchange(small.next());
  send_light(film.client(), kWarm, true);
  for (int i = 0; i < 3; ++i) film.exchange(film.with_corners());
  film.exchange(film.next(false));  // held
  std::this_thread::sleep_for(400ms);
  film.exchange(film.next(false));  // lost
  film.burst(8);
  Envelope bad = film.next();
  bad.mutable_camera_frame()->set_jpeg("no JPEG");
  film.exchange(bad, Envelope::kError);
  const Envelope still = film.next();
  for (int i = 0; i < 4; ++i) film.exchange(still);
}

struct Outcome {
  bool good;
  nlohmann::json json;
};

Outcome replay(RealServer& server, const fs::path& file, bool fast, const fs::path& output = "") {
  load::LoadOptions options;
  options.server = server.server.address();
  options.replay = file;
  options.as_fast_as_possible = fast;
  options.output = output;
  const load::ReplayOutcome outcome = load::run_replay(options);
  return {outcome.good, nlohmann::json::parse(outcome.json)};
}

class RecordReplay : public testing::Test {
 protected:
  net::ServerConfig recording() const {
    net::ServerConfig config;
    config.record.folder = folder_.path();
    return config;
  }

  // A short session, for tests of what is different later.
  fs::path record_one() {
    RealServer server(traced(), recording());
    {
      Filmer film(server, 96, 72);
      for (int i = 0; i < 5; ++i) film.exchange(film.next());
    }
    return folder_.closed(1).at(0);
  }

  RecordFolder folder_;
};

TEST_F(RecordReplay, EveryFrameIsRenderedAgainToTheByte) {
  {
    RealServer server(traced(), recording());
    play_everything(server);
    folder_.closed(2);
  }
  const auto files = folder_.closed(2);
  ASSERT_EQ(files.size(), 2u);
  RealServer server;
  for (const fs::path& file : files) {
    const Outcome outcome = replay(server, file, true);
    EXPECT_TRUE(outcome.good) << outcome.json.dump(2);
    EXPECT_EQ(outcome.json["equal"], outcome.json["frames"]);
    EXPECT_EQ(outcome.json["only_now"], 0);
    EXPECT_TRUE(outcome.json["server_differs"].empty()) << outcome.json["server_differs"];
    EXPECT_EQ(outcome.json["record_ended"], "closed");
  }
  // Something was skipped, or this would not show that skipped frames do no harm.
  const load::RecordedSession film = load::read_recorded_session(files[0]);
  EXPECT_LT(film.turns.size(), film.frames.size());
  EXPECT_GE(film.turns.size(), 17u);
}

// With a fixed exposure no frame depends on which ones were rendered before it.
TEST_F(RecordReplay, InItsOwnTimeWhatBothSessionsHaveIsEqual) {
  frame::RendererSettings settings;
  settings.exposure = 1.0f;
  {
    RealServer server(traced(kMirrorScene, settings), recording());
    play_everything(server);
  }
  const auto files = folder_.closed(2);
  RealServer server(traced(kMirrorScene, settings));
  for (const fs::path& file : files) {
    const Outcome outcome = replay(server, file, false);
    EXPECT_TRUE(outcome.good) << outcome.json.dump(2);
    EXPECT_GE(2 * outcome.json["equal"].get<int>(), outcome.json["frames"].get<int>());
    EXPECT_EQ(outcome.json["different"], 0);
    EXPECT_TRUE(outcome.json["server_differs"].empty());
  }
}

TEST_F(RecordReplay, OtherSettingsAreNamedAndTheirPicturesKept) {
  const fs::path file = record_one();
  frame::RendererSettings settings;
  settings.samples_per_pixel = 4;
  settings.threads = 1;  // decides no byte
  RealServer server(traced(kMirrorScene, settings));
  const fs::path pictures = folder_.path() / "pictures";
  const Outcome outcome = replay(server, file, true, pictures);
  EXPECT_FALSE(outcome.good);
  EXPECT_EQ(outcome.json["different"], 5);
  EXPECT_EQ(outcome.json["first_different"]["number"], 1);
  ASSERT_EQ(outcome.json["server_differs"].size(), 1u);
  EXPECT_EQ(outcome.json["server_differs"][0],
            "options: --renderer raytrace --samples 4, recorded with --renderer raytrace");
  const load::RecordedSession session = load::read_recorded_session(file);
  EXPECT_EQ(bytes_of_file(pictures / "frame-000001-recorded.jpg"), *session.frames[0].jpeg());
  EXPECT_NE(bytes_of_file(pictures / "frame-000001-replayed.jpg"), *session.frames[0].jpeg());
  EXPECT_TRUE(fs::exists(pictures / "frame-000005-replayed.jpg"));
}

// Also one that looks the same, and whichever of its files it is.
TEST_F(RecordReplay, AnotherSceneIsNoticed) {
  const fs::path file = record_one();
  const fs::path copy = folder_.path() / "scene";
  fs::create_directories(copy);
  for (const char* name : {"mirror.gltf", "mirror.bin", "environment.exr"}) {
    fs::copy_file(fs::path(kMirrorScene).parent_path() / name, copy / name);
  }
  {
    RealServer server(traced(copy / "mirror.gltf"));
    EXPECT_TRUE(replay(server, file, true).json["server_differs"].empty());
  }
  std::ofstream(copy / "mirror.bin", std::ios::app) << "    ";
  RealServer server(traced(copy / "mirror.gltf"));
  const Outcome outcome = replay(server, file, true);
  ASSERT_EQ(outcome.json["server_differs"].size(), 1u);
  EXPECT_THAT(outcome.json["server_differs"][0].get<std::string>(), HasSubstr("scene_hash"));
  EXPECT_TRUE(outcome.good);
}

// A server that died in the middle of a frame: the frame is sent again, for it may do so again.
TEST_F(RecordReplay, AFrameUnderWayWhenTheRecordBreaksOffIsPlayedToo) {
  const fs::path file = record_one();
  // Up to where the last frame was rendered, and a little of that.
  std::uintmax_t size = fs::file_size(file);
  const auto records = RecordFolder::read(file);
  for (auto record = records.rbegin(); record != records.rend(); ++record) {
    size -= protocol::encode(*record).size();
    if (record->has_rendered()) break;
  }
  fs::resize_file(file, size + 10);
  RealServer server;
  const Outcome outcome = replay(server, file, true);
  EXPECT_TRUE(outcome.good);
  EXPECT_EQ(outcome.json["record_ended"], "cut");
  EXPECT_EQ(outcome.json["equal"], 4);
  EXPECT_EQ(outcome.json["only_now"], 1);
}

}  // namespace
}  // namespace amalgam::test
