#include "client/viewer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>

#include "client/link/messages.h"
#include "client/sources/images_source.h"
#include "client/sources/jpeg_bytes.h"
#include "client/sources/synthetic_source.h"
#include "client/summary.h"
#include "client/tracking/calibration.h"
#include "unit/client/link/fake_server.h"

namespace amalgam::client {
namespace {

using namespace std::chrono_literals;

std::filesystem::path fresh_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) / "amalgam_viewer" / test->name();
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

Bytes read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write(const std::filesystem::path& file, const Bytes& bytes) {
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

Bytes picture(int width, int height, const std::vector<int>& parameters = {},
              const char* format = ".jpg") {
  cv::Mat image(height, width, CV_8UC3);
  cv::randu(image, 0, 255);
  Bytes bytes;
  cv::imencode(format, image, bytes, parameters);
  return bytes;
}

TEST(ImagesSource, UnreadableFilesAreSaidAtOnce) {
  const auto folder = fresh_folder();
  write(folder / "a.jpg", encode_jpeg(cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(50)), 90));
  std::filesystem::create_directory(folder / "b.jpg");
  const ImagesOptions options{.patterns = {(folder / "*.jpg").string()}, .size = {}};
  EXPECT_THROW(ImagesSource{options}, std::runtime_error);
}

// "a[1].jpg" is also a pattern, which "a1.jpg" matches.
TEST(ImagesSource, ANameIsANameFirst) {
  const auto folder = fresh_folder();
  for (const auto& [name, grey] : {std::pair("a[1].jpg", 50), {"a1.jpg", 200}}) {
    write(folder / name, encode_jpeg(cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(grey)), 90));
  }
  const auto first_grey = [&](const char* pattern) {
    ImagesSource source({.patterns = {(folder / pattern).string()}, .size = {}});
    const auto frame = source.next();
    EXPECT_FALSE(source.next());
    return int{frame->bgr.at<cv::Vec3b>(8, 8)[0]};
  };
  EXPECT_EQ(first_grey("a[1].jpg"), 50);
  EXPECT_EQ(first_grey("a[12].jpg"), 200);
}

TEST(JpegBytes, TellsWhatAServerTakes) {
  EXPECT_TRUE(is_sendable_jpeg(picture(64, 48)));
  EXPECT_FALSE(is_sendable_jpeg(picture(64, 48, {cv::IMWRITE_JPEG_PROGRESSIVE, 1})));
  EXPECT_FALSE(is_sendable_jpeg(picture(64, 48, {}, ".png")));
  Bytes cut = picture(64, 48);
  for (std::size_t size = 0; size < cut.size(); ++size) {
    is_sendable_jpeg(std::span(cut).first(size));  // no sanitiser complains
  }
  cut.resize(20);
  EXPECT_FALSE(is_sendable_jpeg(cut));
  EXPECT_FALSE(is_sendable_jpeg({}));
}

TEST(ImagesSource, PassesBaselineJpegByteForByte) {
  const auto folder = fresh_folder();
  const Bytes first = picture(64, 48), second = picture(64, 48);
  write(folder / "b.jpg", second);
  write(folder / "a.jpg", first);
  ImagesSource source({.patterns = {(folder / "*.jpg").string()}, .size = {}});
  EXPECT_EQ(source.size(), cv::Size(64, 48));
  EXPECT_EQ(source.next()->jpeg, first);
  const auto frame = source.next();
  EXPECT_EQ(frame->jpeg, second);
  EXPECT_EQ(frame->bgr.size(), cv::Size(64, 48));
  EXPECT_FALSE(source.next());
}

TEST(ImagesSource, EncodesWhatAServerDoesNotTake) {
  const auto folder = fresh_folder();
  write(folder / "a.png", picture(64, 48, {}, ".png"));
  write(folder / "b.jpg", picture(64, 48, {cv::IMWRITE_JPEG_PROGRESSIVE, 1}));
  ImagesSource source({.patterns = {(folder / "*").string()}, .size = {}, .repeat = true});
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(is_sendable_jpeg(source.next()->jpeg));
}

TEST(ImagesSource, RefusesWhatItCannotUse) {
  const auto folder = fresh_folder();
  EXPECT_THROW(ImagesSource({.patterns = {(folder / "*").string()}, .size = {}}),
               std::runtime_error);
  write(folder / "a.jpg", picture(64, 48));
  write(folder / "b.jpg", picture(48, 64));
  ImagesSource mixed({.patterns = {(folder / "*").string()}, .size = {}});
  mixed.next();
  EXPECT_THROW(mixed.next(), std::runtime_error);
  ImagesSource scaled({.patterns = {(folder / "*").string()}, .size = {32, 24}});
  EXPECT_EQ(scaled.next()->bgr.size(), cv::Size(32, 24));
  EXPECT_EQ(scaled.next()->bgr.size(), cv::Size(32, 24));
}

struct Outcome {
  ViewerSummary summary;
  std::vector<protocol::CameraFrame> frames;  // as the server got them
};

// Answers what `answers` says yes to.
Outcome view(CameraSource& source, FrameSink* sink, const ViewerOptions& options,
             const std::function<bool(std::uint64_t)>& answers) {
  Outcome outcome;
  FakeServer server({[&](FakePeer& peer) {
    peer.welcome();
    while (const auto message = peer.receive()) {
      if (!message->has_camera_frame()) return;
      outcome.frames.push_back(message->camera_frame());
      if (answers(message->camera_frame().frame_id())) peer.answer(message->camera_frame());
    }
  }});
  const std::atomic<bool> stop = false;
  const auto camera = common::default_camera(source.size().width, source.size().height);
  Connection connection(server.options(3000ms), hello_message(camera, "", 0));
  outcome.summary = Viewer(options, camera, source, sink, connection, stop).run();
  return outcome;
}

TEST(Viewer, AccountsForEveryFrameOfTheSyntheticCamera) {
  SyntheticSource source(common::default_camera(320, 240), true, 90);
  const auto outcome = view(source, nullptr, {.frames = 20, .rate = 500.0},
                            [](std::uint64_t id) { return id % 3 == 0 || id == 20; });
  const FrameCounts& counts = outcome.summary.frames;
  EXPECT_EQ(counts.captured, 20u);
  EXPECT_GT(counts.composited, 0u);
  EXPECT_EQ(counts.composited + counts.skipped_by_client + counts.skipped_by_server, 20u);
  EXPECT_EQ(counts.lost, 0u);
  EXPECT_GT(outcome.summary.latency.median, 0.0);
  EXPECT_LE(outcome.summary.latency.median, outcome.summary.latency.p99);
  for (const auto& frame : outcome.frames) {
    ASSERT_EQ(frame.poses_size(), 1);
    EXPECT_EQ(frame.poses(0).marker(), 40);
  }
}

TEST(Viewer, InLockstepNothingIsSkippedAndBytesComeBackAsFiles) {
  const auto folder = fresh_folder();
  std::vector<Bytes> pictures;
  for (int i = 0; i < 4; ++i) {
    pictures.push_back(picture(64, 48));
    write(folder / ("in" + std::to_string(i) + ".jpg"), pictures.back());
  }
  ImagesSource source({.patterns = {(folder / "in*.jpg").string()}, .size = {}});
  const auto sink = make_folder_sink(folder / "out");
  const auto outcome =
      view(source, sink.get(), {.lockstep = true}, [](std::uint64_t) { return true; });
  EXPECT_EQ(outcome.summary.frames.composited, 4u);
  EXPECT_EQ(outcome.summary.frames.unchanged, 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string name = "frame-00000" + std::to_string(i + 1) + ".jpg";
    EXPECT_EQ(read(folder / "out" / name), pictures[i]);
  }
}

TEST(DisplaySink, ADisplayThatCannotBeReachedIsAnErrorAndNotTheEnd) {
  ::unsetenv("WAYLAND_DISPLAY");
  ::setenv("DISPLAY", ":9999", 1);
  EXPECT_THROW(make_display_sink(), std::runtime_error);
  ::unsetenv("DISPLAY");
  EXPECT_THROW(make_display_sink(), std::runtime_error);
}

TEST(Viewer, RecordsAFilm) {
  const auto folder = fresh_folder();
  SyntheticSource source(common::default_camera(320, 240), true, 90);
  auto sink = make_record_sink(folder / "film.mp4", 25.0);
  view(source, sink.get(), {.frames = 3, .lockstep = true}, [](std::uint64_t) { return true; });
  sink.reset();
  EXPECT_GT(std::filesystem::file_size(folder / "film.mp4"), 1000u);
}

TEST(Viewer, SmoothsPosesAndShowsAnEnvironmentsErrorWithoutLosingAFrame) {
  SyntheticSource source(common::default_camera(160, 120), true, 90);
  FakeServer server({[&](FakePeer& peer) {
    peer.welcome();
    protocol::Envelope error;
    error.mutable_error()->set_code(protocol::Error::BAD_ENVIRONMENT);
    error.mutable_error()->set_text("not a JPEG");
    peer.send(error);
    peer.answer_frames();
  }});
  const std::atomic<bool> stop = false;
  Connection connection(server.options(3000ms),
                        hello_message(common::default_camera(160, 120), "", 0));
  const ViewerSummary summary =
      Viewer({.frames = 12,
              .lockstep = true,
              .smoothing = tracking::OneEuroOptions{.min_cutoff = 2.0}},
             common::default_camera(160, 120), source, nullptr, connection, stop)
          .run();
  EXPECT_EQ(summary.frames.composited, 12u);
  EXPECT_EQ(summary.frames.rejected, 0u);
  EXPECT_EQ(summary.server_errors, 1u);
  EXPECT_NE(summary_text(summary).find("BAD_ENVIRONMENT: not a JPEG"), std::string::npos);
  ASSERT_TRUE(summary.smoothing);
  EXPECT_EQ(summary.smoothing->poses, 12u);
  EXPECT_NE(summary_text(summary).find("lag"), std::string::npos);
  EXPECT_NE(summary_json(summary).find("\"lag_ms\""), std::string::npos);
}

TEST(Viewer, LooksForTheMarkersOfTheWelcomeAndOfANewOne) {
  SyntheticSource source(common::default_camera(320, 240), false, 90);
  std::vector<int> poses;
  const auto count = [&](FakePeer& peer) {
    const auto message = peer.receive();
    if (!message || !message->has_camera_frame()) return;
    poses.push_back(message->camera_frame().poses_size());
    peer.answer(message->camera_frame());
  };
  FakeServer server({[&](FakePeer& peer) {
                       peer.welcome({23});
                       count(peer);
                     },
                     [&](FakePeer& peer) {
                       peer.welcome({23, 40});
                       for (int i = 0; i < 3; ++i) count(peer);
                     }});
  const std::atomic<bool> stop = false;
  const auto camera = common::default_camera(320, 240);
  Connection connection(server.options(3000ms), hello_message(camera, "", 0));
  Viewer({.frames = 4, .rate = 4.0}, camera, source, nullptr, connection, stop).run();
  ASSERT_GE(poses.size(), 2u);
  EXPECT_EQ(poses.front(), 0);  // only 40 is there
  EXPECT_EQ(poses.back(), 1);
}

// What was counted before another scene came is not forgotten.
TEST(Viewer, TheSummaryIsOfAllScenes) {
  SyntheticSource source(common::default_camera(320, 240), false, 90);
  const auto take = [](FakePeer& peer, int frames) {
    for (int i = 0; i < frames; ++i) {
      const auto message = peer.receive();
      if (message && message->has_camera_frame()) peer.answer(message->camera_frame());
    }
  };
  FakeServer server({[&](FakePeer& peer) {
                       peer.welcome({40});
                       take(peer, 3);
                     },
                     [&](FakePeer& peer) {
                       peer.welcome({40, 23});
                       take(peer, 3);
                       peer.receive();
                     }});
  const std::atomic<bool> stop = false;
  const auto camera = common::default_camera(320, 240);
  Connection connection(server.options(3000ms), hello_message(camera, "", 0));
  // A band as wide as this holds all poses but each tracker's first one.
  const ViewerSummary summary = Viewer({.frames = 6, .rate = 5.0, .dead_band = 1e6}, camera, source,
                                       nullptr, connection, stop)
                                    .run();
  EXPECT_EQ(summary.reconnects, 1u);
  EXPECT_EQ(summary.markers.images, 6u);
  EXPECT_EQ(summary.markers.poses, 6u);
  EXPECT_EQ(summary.poses_held, 4u);
}

TEST(Viewer, AServerMustNotNameAFile) {
  SyntheticSource source(common::default_camera(64, 48), true, 90);
  FakeServer server({[](FakePeer& peer) {
    peer.receive();
    protocol::Envelope envelope;
    protocol::Markers& markers = *envelope.mutable_welcome()->mutable_markers();
    markers.set_dictionary("/home/user/secret.yml");
    markers.set_length(0.05);
    peer.send(envelope);
    peer.receive();
  }});
  const std::atomic<bool> stop = false;
  const auto camera = common::default_camera(64, 48);
  Connection connection(server.options(3000ms), hello_message(camera, "", 0));
  try {
    Viewer({.frames = 1}, camera, source, nullptr, connection, stop).run();
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("unknown marker dictionary"));
  }
}

TEST(FolderSink, SaysWhyAFolderCannotBeMade) {
  const auto folder = fresh_folder() / std::string(300, 'x');
  try {
    make_folder_sink(folder);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(),
              "--output: " + folder.string() + " cannot be made (File name too long)");
  }
}

TEST(FramesInFlight, CountsByWhatTheAnswerSays) {
  FramesInFlight ledger;
  const FramesInFlight::Clock::time_point start{};
  for (std::uint64_t id = 1; id <= 8; ++id) ledger.captured(id, start + id * 10ms);
  ledger.skipped(2);
  ledger.composited(3, true, start + 50ms);  // 1 will never be answered
  ledger.composited(3, true, start + 60ms);  // once is enough
  ledger.rejected(4);
  ledger.composited(5, false, start + 60ms);
  ledger.lost_up_to(7);
  EXPECT_TRUE(ledger.is_open(8));
  ledger.composited(8, false, start + 180ms);
  EXPECT_FALSE(ledger.has_open());
  const FrameCounts& counts = ledger.counts();
  EXPECT_EQ(counts.captured, 8u);
  EXPECT_EQ(counts.composited, 3u);
  EXPECT_EQ(counts.unchanged, 1u);
  EXPECT_EQ(counts.skipped_by_client, 1u);
  EXPECT_EQ(counts.skipped_by_server, 1u);
  EXPECT_EQ(counts.rejected, 1u);
  EXPECT_EQ(counts.lost, 2u);
  EXPECT_FLOAT_EQ(static_cast<float>(ledger.latency().median), 20.0f);
  EXPECT_FLOAT_EQ(static_cast<float>(ledger.latency().p99), 100.0f);
}

// The nearest rank: of 1 to 100 ms the 50th, the 95th and the 99th.
TEST(FramesInFlight, PercentilesAreOfTheNearestRank) {
  FramesInFlight ledger;
  const FramesInFlight::Clock::time_point start{};
  for (std::uint64_t id = 1; id <= 100; ++id) {
    ledger.captured(id, start);
    ledger.composited(id, false, start + id * 1ms);
  }
  EXPECT_FLOAT_EQ(static_cast<float>(ledger.latency().median), 50.0f);
  EXPECT_FLOAT_EQ(static_cast<float>(ledger.latency().p95), 95.0f);
  EXPECT_FLOAT_EQ(static_cast<float>(ledger.latency().p99), 99.0f);
}

TEST(Summary, IsOneLineOfJsonWhateverTheServerSays) {
  ViewerSummary summary;
  summary.last_error = "bad bytes \xff\xfe\n\"";
  const std::string json = summary_json(summary);
  EXPECT_EQ(json.find('\n'), std::string::npos);
  EXPECT_EQ(json.front(), '{');
  EXPECT_EQ(json.back(), '}');
}

}  // namespace
}  // namespace amalgam::client
