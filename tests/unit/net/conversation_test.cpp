// A conversation without a socket: what is said in answer to what.
#include "net/conversation.h"

#include <gtest/gtest.h>

#include <vector>

#include "net/wire.h"
#include "support/net/stub_frame_service.h"
#include "support/net/test_client.h"

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
