#include "frame/render_thread.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <future>
#include <mutex>

#include "codec/jpeg.h"
#include "frame/default_view.h"

namespace amalgam::frame {
namespace {

const std::string kScene = AMALGAM_SOURCE_DIR "/deploy/scenes/diffuse.gltf";

// Collects what is delivered, and waits for it.
class Inbox {
 public:
  FrameService::Deliver deliver() {
    return [this](std::uint64_t id, FrameResult result) {
      const std::lock_guard lock(mutex_);
      results_.emplace_back(id, std::move(result));
      arrived_.notify_all();
    };
  }
  bool wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    return arrived_.wait_for(lock, std::chrono::seconds(60),
                             [&] { return results_.size() >= count; });
  }
  std::pair<std::uint64_t, FrameResult> at(std::size_t i) {
    const std::lock_guard lock(mutex_);
    return results_.at(i);
  }
  std::size_t size() {
    const std::lock_guard lock(mutex_);
    return results_.size();
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::vector<std::pair<std::uint64_t, FrameResult>> results_;
};

ViewOptions small_view() {
  return {.camera = common::default_camera(64, 48)};
}

FrameInput grey_frame() {
  return {codec::encode_jpeg(common::ImageRgb8(64, 48, common::Rgb8(128)), 90), {default_pose(40)}};
}

TEST(RenderThread, TellsWhichMarkersToLookFor) {
  const RenderThread service(kScene, {});
  const auto markers = service.markers();
  EXPECT_EQ(markers.dictionary, "DICT_6X6_250");
  ASSERT_FALSE(markers.ids.empty());
  EXPECT_EQ(markers.ids.front(), 40);
}

TEST(RenderThread, ServesViewsAndReportsBadImages) {
  Inbox a, b;
  RenderThread service(kScene, {});
  const ViewId first = service.open_view(small_view(), a.deliver());
  const ViewId second = service.open_view(small_view(), b.deliver());
  service.submit(first, 1, grey_frame());
  FrameInput broken = grey_frame();
  std::get<Bytes>(broken.image).resize(100);
  service.submit(second, 7, std::move(broken));
  ASSERT_TRUE(a.wait_for(1));
  ASSERT_TRUE(b.wait_for(1));
  EXPECT_TRUE(std::holds_alternative<FrameOutput>(a.at(0).second));
  ASSERT_TRUE(std::holds_alternative<FrameFailure>(b.at(0).second));
  EXPECT_EQ(std::get<FrameFailure>(b.at(0).second).kind, FrameFailure::Kind::BadImage);
  // The view goes on after a bad image.
  service.submit(second, 8, grey_frame());
  ASSERT_TRUE(b.wait_for(2));
  EXPECT_EQ(b.at(1).first, 8u);
  EXPECT_TRUE(std::holds_alternative<FrameOutput>(b.at(1).second));
}

// Every submitted frame is either delivered or reported as replaced.
TEST(RenderThread, NewestWins) {
  Inbox inbox;
  RenderThread service(kScene, {});
  const ViewId view = service.open_view(small_view(), inbox.deliver());
  std::size_t replaced = 0;
  constexpr std::uint64_t kFrames = 40;
  for (std::uint64_t id = 1; id <= kFrames; ++id)
    replaced += service.submit(view, id, grey_frame());
  ASSERT_TRUE(inbox.wait_for(kFrames - replaced));
  EXPECT_EQ(inbox.at(inbox.size() - 1).first, kFrames) << "the last one is never skipped";
  EXPECT_EQ(inbox.size() + replaced, kFrames);
}

TEST(RenderThread, NothingIsDeliveredAfterClosing) {
  RenderThread service(kScene, {});
  Inbox inbox;
  const ViewId view = service.open_view(small_view(), inbox.deliver());
  service.submit(view, 1, grey_frame());
  service.close_view(view);
  const std::size_t delivered = inbox.size();
  Inbox other;
  const ViewId next = service.open_view(small_view(), other.deliver());
  service.submit(next, 1, grey_frame());
  ASSERT_TRUE(other.wait_for(1));
  EXPECT_EQ(inbox.size(), delivered);
  EXPECT_FALSE(service.submit(view, 2, grey_frame())) << "a closed view takes nothing";
}

TEST(RenderThread, EnvironmentIsReplacedOrRefusedWithAReason) {
  RenderThread service(kScene, {});
  const auto set = [&](EnvironmentInput input) {
    std::promise<std::optional<std::string>> answer;
    service.set_environment(std::move(input),
                            [&](std::optional<std::string> error) { answer.set_value(error); });
    return answer.get_future().get();
  };
  const Bytes picture =
      codec::encode_jpeg(common::ImageRgb8(64, 32, common::Rgb8(200, 40, 40)), 90);
  EXPECT_EQ(set({.image = picture}), std::nullopt);
  EXPECT_TRUE(set({.image = Bytes(10)}).has_value());
  EXPECT_TRUE(
      set({.image = picture, .projection = EnvironmentInput::Projection::Fisheye}).has_value())
      << "a fish-eye without calibration";
  // Frames go on under the new light.
  Inbox inbox;
  const ViewId view = service.open_view(small_view(), inbox.deliver());
  service.submit(view, 1, grey_frame());
  ASSERT_TRUE(inbox.wait_for(1));
  EXPECT_TRUE(std::holds_alternative<FrameOutput>(inbox.at(0).second));
}

// Views take turns, whoever is quickest.
TEST(RenderThread, AViewThatSubmitsAgainAtOnceDoesNotStarveTheOthers) {
  std::vector<int> served;  // written by the render thread until it is done
  std::promise<void> done;
  RenderThread service(kScene, {});
  ViewId first = 0, eager = 0, last = 0;
  first = service.open_view(small_view(), [&](auto, const auto&) { served.push_back(1); });
  eager = service.open_view(small_view(), [&](std::uint64_t frame, const auto&) {
    served.push_back(2);
    if (frame == 3) return done.set_value();
    service.submit(eager, frame + 1, grey_frame());
    if (frame == 1) {
      service.submit(first, 1, grey_frame());
      service.submit(last, 1, grey_frame());
    }
  });
  last = service.open_view(small_view(), [&](auto, const auto&) { served.push_back(3); });
  service.submit(eager, 1, grey_frame());
  ASSERT_EQ(done.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
  EXPECT_EQ(served, (std::vector{2, 3, 1, 2, 2}));
}

// Whoever sent an environment hears what became of it, even if a newer one came before its turn.
TEST(RenderThread, TheSenderOfAReplacedEnvironmentIsAnswered) {
  const EnvironmentInput input{
      .image = codec::encode_jpeg(common::ImageRgb8(64, 32, common::Rgb8(200, 40, 40)), 90)};
  std::optional<std::string> answer;
  std::promise<std::optional<std::string>> newer;
  RenderThread service(kScene, {});
  // While it delivers, the render thread takes no environment.
  const ViewId view = service.open_view(small_view(), [&](auto, const auto&) {
    service.set_environment(input, [&](std::optional<std::string> error) { answer = error; });
    EXPECT_FALSE(answer.has_value());
    service.set_environment(input,
                            [&](std::optional<std::string> error) { newer.set_value(error); });
    EXPECT_TRUE(answer.has_value());
  });
  service.submit(view, 1, grey_frame());
  auto applied = newer.get_future();
  ASSERT_EQ(applied.wait_for(std::chrono::seconds(60)), std::future_status::ready);
  EXPECT_EQ(applied.get(), std::nullopt);
  EXPECT_TRUE(answer.has_value());
}

TEST(RenderThread, StartFailureReachesTheCaller) {
  EXPECT_THROW(RenderThread("/nowhere/scene.gltf", {}), std::exception);
}

TEST(RenderThread, UnusableCameraIsRefused) {
  RenderThread service(kScene, {});
  EXPECT_THROW(service.open_view({}, [](std::uint64_t, FrameResult) {}), std::invalid_argument);
}

}  // namespace
}  // namespace amalgam::frame
