// Records of sessions without a server: what is in them, and where they end.
#include "record/recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <new>

#include "protocol/framing.h"
#include "record/session_recording.h"
#include "support/record_folder.h"

namespace amalgam::record {
namespace {

using protocol::Envelope;
using protocol::RecordEnd;
using protocol::SessionRecord;
using test::RecordFolder;

constexpr const char* kSecret = "a token that nobody may read";

protocol::Hello hello() {
  protocol::Hello hello;
  hello.set_version(1);
  hello.set_token(kSecret);
  return hello;
}

Envelope frame(std::size_t bytes) {
  Envelope envelope;
  envelope.mutable_camera_frame()->set_jpeg(std::string(bytes, 'j'));
  return envelope;
}

Envelope environment(const std::string& image, bool own) {
  Envelope envelope;
  envelope.mutable_environment()->set_image(image);
  envelope.mutable_environment()->set_own(own);
  return envelope;
}

protocol::Fingerprint fingerprint() {
  protocol::Fingerprint fingerprint;
  fingerprint.set_scene("desk.gltf");
  return fingerprint;
}

class RecorderTest : public testing::Test {
 protected:
  RecordOptions options() const {
    return {.folder = folder_.path(), .session_bytes = 1 << 20, .total_bytes = 1 << 30};
  }
  // Of the one session.
  std::vector<SessionRecord> only_record() const {
    const auto files = folder_.files();
    EXPECT_EQ(files.size(), 1u);
    return files.empty() ? std::vector<SessionRecord>() : RecordFolder::read(files[0]);
  }

  RecordFolder folder_;
};

// A session in a block of its own; the recorder has written everything when it is gone.
TEST_F(RecorderTest, HasWhatWasSaidAndNoToken) {
  {
    Recorder recorder(options());
    SessionRecording session(&recorder);
    session.received(frame(1));  // before its hello: no session yet
    session.begin(7, hello(), fingerprint());
    EXPECT_EQ(session.fate(), Fate::On);
    Envelope second_hello;
    *second_hello.mutable_hello() = hello();
    session.received(second_hello);
    session.received(frame(100));
    session.submitted(2, std::vector<common::MarkerPose>{{.marker = 40}});
    protocol::Composite composite;
    composite.set_jpeg("composite");
    session.rendered(2, [&] { return composite; });
    session.written();
    composite.set_unchanged(true);
    session.rendered(3, [&] { return composite; });
  }
  const auto files = folder_.files();
  ASSERT_EQ(files.size(), 1u);
  EXPECT_THAT(test::bytes_of_file(files[0]), testing::Not(testing::HasSubstr(kSecret)));
  const protocol::SessionRecordReader reader(files[0]);
  EXPECT_EQ(reader.header().session(), 7u);
  EXPECT_EQ(reader.header().hello().version(), 1u);
  EXPECT_EQ(reader.header().fingerprint().scene(), "desk.gltf");
  const auto records = RecordFolder::read(files[0]);
  ASSERT_EQ(records.size(), 7u);
  EXPECT_TRUE(records[0].received().envelope().has_hello());
  EXPECT_EQ(records[1].received().number(), 2u);
  EXPECT_EQ(records[1].received().envelope().camera_frame().jpeg().size(), 100u);
  EXPECT_EQ(records[2].submitted().poses(0).marker(), 40);
  EXPECT_EQ(records[3].rendered().composite().jpeg(), "composite");
  EXPECT_EQ(records[4].written().frame(), 2u);
  EXPECT_EQ(records[5].rendered().composite().jpeg(), "");  // the client's own
  EXPECT_EQ(records[6].end().reason(), RecordEnd::CLOSED);
  EXPECT_TRUE(std::ranges::is_sorted(records, {}, &SessionRecord::time_us));
}

TEST_F(RecorderTest, NothingWithoutAFolder) {
  Recorder recorder({});
  SessionRecording session(&recorder), without_recorder(nullptr);
  for (SessionRecording* recording : {&session, &without_recorder}) {
    recording->begin(1, hello(), {});
    recording->received(frame(10));
    EXPECT_EQ(recording->fate(), Fate::Off);
  }
  EXPECT_EQ(recorder.report().counts.begun, 0u);
}

TEST_F(RecorderTest, AFullRecordEndsAndSaysSo) {
  RecordOptions small = options();
  small.session_bytes = 10'000;
  {
    Recorder recorder(small);
    SessionRecording session(&recorder);
    session.begin(1, hello(), {});
    for (int i = 0; i < 20; ++i) session.received(frame(1000));
  }
  const auto files = folder_.files();
  EXPECT_LE(std::filesystem::file_size(files.at(0)), small.session_bytes);
  EXPECT_GT(std::filesystem::file_size(files.at(0)), small.session_bytes - 1100);
  const auto records = only_record();
  EXPECT_EQ(records.size(), 10u);  // nine frames, and the end
  EXPECT_EQ(records.back().end().reason(), RecordEnd::FULL);
}

// Counted, and a session that goes on does not begin anew.
TEST_F(RecorderTest, AllRecordsTogetherAreBounded) {
  RecordOptions small = options();
  small.total_bytes = 10'000;
  std::ofstream(folder_.path() / "earlier-1.session") << std::string(4000, 'e');
  Recorder recorder(small);
  SessionRecording first(&recorder), second(&recorder);
  first.begin(2, hello(), {});
  second.begin(3, hello(), {});
  for (int i = 0; i < 10; ++i) {
    first.received(frame(1000));
    second.received(frame(1000));
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (recorder.report().counts.ended < 2 && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(first.fate(), Fate::Full);
  EXPECT_EQ(second.fate(), Fate::Full);
  EXPECT_EQ(recorder.report().counts.full, 2u);
  EXPECT_EQ(recorder.report().counts.bytes, first.bytes() + second.bytes());
  std::uint64_t bytes = 0;
  for (const auto& file : folder_.files()) bytes += std::filesystem::file_size(file);
  EXPECT_LE(bytes, small.total_bytes);
  EXPECT_GT(bytes, small.total_bytes - 2200);
}

// The disk is as slow as can be: nothing may wait for it.
TEST_F(RecorderTest, ASlowDiskEndsTheRecord) {
  {
    Recorder recorder(options(), 5000);
    SessionRecording session(&recorder);
    session.begin(1, hello(), {});
    session.received(frame(6000));
    EXPECT_EQ(session.fate(), Fate::TooSlow);
    session.received(frame(10));
    EXPECT_EQ(recorder.report().counts.too_slow, 1u);
  }
  const auto records = only_record();
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].end().reason(), RecordEnd::TOO_SLOW);
}

TEST_F(RecorderTest, AFolderThatIsGoneIsCounted) {
  RecordOptions gone = options();
  gone.folder += "/gone";
  Recorder recorder(gone);
  SessionRecording session(&recorder);
  session.begin(1, hello(), {});
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (session.fate() == Fate::On && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(session.fate(), Fate::Failed);
  EXPECT_EQ(recorder.report().counts.failed, 1u);
}

// What a record needs and cannot get ends the record.
TEST_F(RecorderTest, WithoutMemoryTheRecordEndsAndNothingIsThrown) {
  Recorder recorder(options());
  SessionRecording session(&recorder);
  session.begin(1, hello(), {});
  EXPECT_NO_THROW(session.rendered(1, []() -> protocol::Composite { throw std::bad_alloc(); }));
  EXPECT_EQ(session.fate(), Fate::Failed);
  EXPECT_NO_THROW(session.rendered(2, []() -> protocol::Composite {
    ADD_FAILURE() << "nothing is recorded any more";
    return {};
  }));
}

TEST_F(RecorderTest, AReloadEndsRecords) {
  {
    Recorder recorder(options());
    SessionRecording before(&recorder), after(&recorder);
    before.begin(1, hello(), {});
    recorder.reloaded(options());
    EXPECT_EQ(before.fate(), Fate::Reloaded);
    before.received(frame(10));
    after.begin(2, hello(), {});
  }
  const auto files = folder_.files();
  ASSERT_EQ(files.size(), 2u);
  const auto records = RecordFolder::read(files[0]);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].end().reason(), RecordEnd::RELOADED);
}

// Of a session's own environments those that took effect are named; those for all are in the
// records of others, too, whether these had begun or not.
TEST_F(RecorderTest, LightIsInTheRecordsOfAllThatItLights) {
  {
    Recorder recorder(options());
    SessionRecording first(&recorder), second(&recorder), third(&recorder);
    first.begin(1, hello(), {});
    second.begin(2, hello(), {});
    first.received(environment("refused", false));
    first.received(environment("for all", false));
    first.environment_accepted();
    first.received(environment("unusable", true));
    first.environment_accepted();
    first.environment_done(true);
    first.environment_done(false);
    third.begin(3, hello(), {});
    third.received(environment("own", true));
    third.environment_accepted();
    third.environment_done(true);
  }
  const auto files = folder_.files();
  ASSERT_EQ(files.size(), 3u);
  const auto lights = [&](std::size_t index) {
    std::vector<protocol::LightChange> lights;
    for (const auto& record : RecordFolder::read(files[index])) {
      if (record.has_light()) lights.push_back(record.light());
    }
    return lights;
  };
  ASSERT_EQ(lights(0).size(), 1u);
  EXPECT_EQ(lights(0)[0].environment(), 2u);
  ASSERT_EQ(lights(1).size(), 1u);
  EXPECT_EQ(lights(1)[0].from_another().image(), "for all");
  ASSERT_EQ(lights(2).size(), 2u);
  EXPECT_EQ(lights(2)[0].from_another().image(), "for all");
  EXPECT_EQ(lights(2)[1].environment(), 1u);
}

// The scene's own light is back.
TEST_F(RecorderTest, AReloadForgetsTheLight) {
  {
    Recorder recorder(options());
    SessionRecording first(&recorder), second(&recorder);
    first.begin(1, hello(), {});
    first.received(environment("for all", false));
    first.environment_accepted();
    first.environment_done(true);
    recorder.reloaded(options());
    second.begin(2, hello(), {});
  }
  EXPECT_EQ(RecordFolder::read(folder_.files().at(1)).size(), 1u);  // the end
}

}  // namespace
}  // namespace amalgam::record
