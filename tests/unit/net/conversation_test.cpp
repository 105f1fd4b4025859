// A conversation without a socket: what is said in answer to what.
#include "net/conversation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "net/wire.h"
#include "protocol/geometry.h"
#include "support/net/stub_frame_service.h"
#include "support/net/test_client.h"
#include "tracking/square_pose.h"

namespace amalgam::net {
namespace {

using protocol::Envelope;
using protocol::Error;

// Keeps what would be written. Steps of other threads wait until the test runs them.
class RecordingLine : public Line {
 public:
  void send(const Envelope& message) override { said.push_back(message); }
  bool send_answer(Answer answer) override {
    answers.push_back(std::move(answer));
    return false;
  }
  void send_last(const Envelope& error) override {
    said.push_back(error);
    closed = true;
  }
  void welcomed() override { ++welcomes; }
  void refused() override { ++refusals; }
  void heard_pong(std::uint64_t nonce) override { pongs.push_back(nonce); }
  void close() override { closed = true; }
  std::function<void(Step)> posting() override {
    return [this](Step step) {
      const std::lock_guard lock(mutex_);
      steps_.push_back(std::move(step));
      arrived_.notify_all();
    };
  }

  // Waits for a step from the renderer and runs it.
  bool run_one() {
    Step step;
    {
      std::unique_lock lock(mutex_);
      if (!arrived_.wait_for(lock, std::chrono::seconds(10), [&] { return !steps_.empty(); })) {
        return false;
      }
      step = std::move(steps_.front());
      steps_.pop_front();
    }
    step();
    return true;
  }

  std::vector<Envelope> said;
  std::vector<Answer> answers;
  std::vector<std::uint64_t> pongs;
  int welcomes = 0, refusals = 0;
  bool closed = false;

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<Step> steps_;
};

// A marker half a metre ahead that looks at the camera.
common::MarkerPose facing(int marker, double x) {
  return {.marker = marker, .rotation = {0.0, 1.0, 0.0, 0.0}, .translation = {x, 0.0, 0.5}};
}

void add_corners(Envelope& frame, const common::MarkerPose& pose) {
  const common::CameraModel camera = protocol::from_message(test::hello_message().hello().camera());
  protocol::MarkerCorners& wire = *frame.mutable_camera_frame()->add_corners();
  wire.set_marker(pose.marker);
  const tracking::SquareCorners corners = tracking::project_square(pose, 0.05, camera).value();
  for (const glm::dvec2& corner : corners) {
    wire.add_pixels(static_cast<float>(corner.x));
    wire.add_pixels(static_cast<float>(corner.y));
  }
}

class ConversationTest : public testing::Test {
 protected:
  // What the line's guard does with a client's mistake.
  void hear(const Envelope& message) {
    try {
      conversation_.visit(message);
    } catch (const ClientError& error) {
      conversation_.answer(error);
    }
  }

  ServerConfig config_;
  Metrics metrics_;
  test::StubFrameService service_;
  Admission admission_{config_.admission};
  ServerContext context_{config_, service_, metrics_, admission_, false};
  RecordingLine line_;
  Conversation conversation_{7, "nobody", line_, context_};
};

TEST_F(ConversationTest, AFrameGoesToTheRendererAndBack) {
  hear(test::hello_message());
  ASSERT_EQ(line_.said.size(), 1u);
  EXPECT_EQ(line_.said[0].welcome().session(), 7u);
  EXPECT_EQ(line_.welcomes, 1);
  Envelope frame = test::frame_message(41);
  test::add_pose(frame, 40);
  hear(frame);
  ASSERT_TRUE(line_.run_one());
  ASSERT_EQ(line_.answers.size(), 1u);
  const Envelope composite = composite_message(line_.answers[0], conversation_.skipped());
  EXPECT_EQ(composite.composite().frame_id(), 41u);
  EXPECT_EQ(composite.composite().capture_time_us(), 41000u);
  EXPECT_EQ(composite.composite().poses_size(), 1);
}

TEST_F(ConversationTest, NoPictureIsKeptUnlessItIsWanted) {
  hear(test::hello_message());
  hear(test::frame_message(1));
  ASSERT_TRUE(line_.run_one());
  EXPECT_FALSE(conversation_.picture());
}

TEST_F(ConversationTest, OnePictureIsKeptUntilTheSessionEnds) {
  config_.admin_pictures = true;
  hear(test::hello_message());
  std::weak_ptr<const frame::Bytes> before;
  for (const char* jpeg : {"one", "other"}) {
    hear(test::frame_message(1, jpeg));
    ASSERT_TRUE(line_.run_one());
    EXPECT_TRUE(before.expired());
    before = conversation_.picture();
    ASSERT_FALSE(before.expired());
    EXPECT_EQ(before.lock()->size(), std::string(jpeg).size());
  }
  conversation_.leave();
  EXPECT_TRUE(before.expired());
}

TEST_F(ConversationTest, PosesOfCornersAreSolvedAndEchoed) {
  hear(test::hello_message());
  Envelope frame = test::frame_message(41);
  add_corners(frame, facing(40, 0.02));
  add_corners(frame, facing(23, -0.03));
  add_corners(frame, facing(9, 0.0));  // not the scene's
  hear(frame);
  ASSERT_TRUE(line_.run_one());
  ASSERT_EQ(line_.answers.size(), 1u);
  const auto& poses = line_.answers[0].frame.poses;
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].marker, 23);
  EXPECT_EQ(poses[1].marker, 40);
  EXPECT_NEAR(glm::distance(poses[1].translation, facing(40, 0.02).translation), 0.0, 1e-4);
}

// Or a small message would cost the thread of all clients 64 solutions.
TEST_F(ConversationTest, OfOneMarkersCornersTwoAreSolved) {
  hear(test::hello_message());
  Envelope first = test::frame_message(1);
  add_corners(first, facing(40, 0.1));
  hear(first);
  ASSERT_TRUE(line_.run_one());
  Envelope frame = test::frame_message(2);
  for (const double x : {-0.1, 0.0, 0.1}) add_corners(frame, facing(40, x));
  hear(frame);
  ASSERT_TRUE(line_.run_one());
  ASSERT_EQ(line_.answers.size(), 2u);
  ASSERT_EQ(line_.answers[1].frame.poses.size(), 1u);
  EXPECT_NEAR(line_.answers[1].frame.poses[0].translation.x, 0.0, 1e-4);
}

TEST_F(ConversationTest, APoseWinsOverTheCornersOfItsMarker) {
  hear(test::hello_message());
  Envelope frame = test::frame_message(41);
  add_corners(frame, facing(40, 0.02));
  *frame.mutable_camera_frame()->add_poses() = protocol::to_message(facing(40, 0.1));
  hear(frame);
  ASSERT_TRUE(line_.run_one());
  ASSERT_EQ(line_.answers.size(), 1u);
  ASSERT_EQ(line_.answers[0].frame.poses.size(), 1u);
  EXPECT_EQ(line_.answers[0].frame.poses[0].translation.x, 0.1);
}

TEST_F(ConversationTest, CornersThatAreNoFourPlacesAreNamed) {
  hear(test::hello_message());
  Envelope frame = test::frame_message(41);
  add_corners(frame, facing(40, 0.02));
  add_corners(frame, facing(23, 0.02));
  frame.mutable_camera_frame()->mutable_corners(0)->mutable_pixels()->RemoveLast();
  frame.mutable_camera_frame()->mutable_corners(1)->set_pixels(3, NAN);
  frame.mutable_camera_frame()->add_corners()->set_marker(5);
  hear(frame);
  ASSERT_TRUE(line_.run_one());
  ASSERT_EQ(line_.said.size(), 2u);
  EXPECT_EQ(line_.said[1].error().code(), Error::POSE_REJECTED);
  EXPECT_THAT(line_.said[1].error().text(), testing::EndsWith("40 23 5"));
  ASSERT_EQ(line_.answers.size(), 1u);
  EXPECT_TRUE(line_.answers[0].frame.poses.empty());
}

// The same jump of a marker, raw and with a cut-off of 1 Hz at 30 frames a second.
TEST_F(ConversationTest, SolvedPosesAreSmoothedIfTheHelloAsksForIt) {
  Envelope hello = test::hello_message();
  hello.mutable_hello()->mutable_smoothing()->set_min_cutoff(1.0);
  hear(hello);
  for (std::uint64_t i = 0; i < 2; ++i) {
    Envelope frame = test::frame_message(i + 1);
    frame.mutable_camera_frame()->set_capture_time_us(1'000'000 + i * 33'333);
    add_corners(frame, facing(40, i == 0 ? 0.0 : 0.1));
    hear(frame);
    ASSERT_TRUE(line_.run_one());
  }
  ASSERT_EQ(line_.answers.size(), 2u);
  // 2 pi f t / (1 + 2 pi f t) of the way.
  EXPECT_NEAR(line_.answers[1].frame.poses.at(0).translation.x, 0.1 * 0.1732, 1e-3);
}

TEST_F(ConversationTest, ASmoothingThatIsNoneIsRefused) {
  for (const auto& [cutoff, beta] :
       {std::pair(0.0, 0.0), {-1.0, 0.0}, {1.0, -1.0}, {NAN, 0.0}, {1.0, INFINITY}, {1e9, 0.0}}) {
    Envelope hello = test::hello_message();
    hello.mutable_hello()->mutable_smoothing()->set_min_cutoff(cutoff);
    hello.mutable_hello()->mutable_smoothing()->set_beta(beta);
    RecordingLine line;
    Conversation conversation(1, "nobody", line, context_);
    EXPECT_THROW(conversation.visit(hello), ClientError) << cutoff << ' ' << beta;
  }
}

// Any capture time must do: 2^64 us are more than a clock of nanoseconds can count.
TEST_F(ConversationTest, CornersAtTheEndOfTimeAreSolvedToo) {
  Envelope hello = test::hello_message();
  hello.mutable_hello()->mutable_smoothing()->set_min_cutoff(1.0);
  hear(hello);
  Envelope frame = test::frame_message(1);
  frame.mutable_camera_frame()->set_capture_time_us(UINT64_MAX);
  add_corners(frame, facing(40, 0.02));
  hear(frame);
  ASSERT_TRUE(line_.run_one());
  ASSERT_EQ(line_.answers.size(), 1u);
  EXPECT_EQ(line_.answers[0].frame.poses.size(), 1u);
}

TEST_F(ConversationTest, OneFailureHasOneNumberTheClients) {
  hear(test::hello_message());
  hear(test::frame_message(41, test::kBadJpeg));
  ASSERT_TRUE(line_.run_one());
  ASSERT_EQ(line_.said.size(), 2u);
  EXPECT_EQ(line_.said[1].error().code(), Error::BAD_IMAGE);
  EXPECT_EQ(line_.said[1].error().frame_id(), 41u);
  EXPECT_FALSE(line_.closed);
}

TEST_F(ConversationTest, NothingIsSaidAfterLeaving) {
  hear(test::hello_message());
  service_.hold();
  hear(test::frame_message(1));
  ASSERT_TRUE(service_.wait_taken(1));
  conversation_.leave();
  EXPECT_TRUE(service_.wait_views(0));
  service_.release();
  EXPECT_EQ(conversation_.skipped(), 1u);
  EXPECT_TRUE(line_.answers.empty());
}

TEST_F(ConversationTest, DrainsWhenTheLastFrameIsAnswered) {
  hear(test::hello_message());
  service_.hold();
  hear(test::frame_message(1));
  conversation_.drain(std::chrono::seconds(1));
  EXPECT_FALSE(conversation_.drained());
  hear(test::frame_message(2));
  service_.release();
  ASSERT_TRUE(line_.run_one());
  EXPECT_TRUE(conversation_.drained());
  EXPECT_EQ(line_.answers.size(), 1u);
  EXPECT_EQ(conversation_.skipped(), 1u);
}

TEST_F(ConversationTest, ALastErrorCloses) {
  hear(test::frame_message(1));
  ASSERT_EQ(line_.said.size(), 1u);
  EXPECT_EQ(line_.said[0].error().code(), Error::UNEXPECTED_MESSAGE);
  EXPECT_TRUE(line_.closed);
}

}  // namespace
}  // namespace amalgam::net
