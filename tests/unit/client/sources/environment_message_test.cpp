// Environments as the client reads and sends them.
#include "client/sources/environment_message.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <opencv2/imgcodecs.hpp>

#include "client/link/messages.h"
#include "client/sources/jpeg_bytes.h"
#include "unit/client/link/fake_server.h"

namespace amalgam::client {
namespace {

using namespace std::chrono_literals;

std::filesystem::path file_of(const std::string& ending) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(testing::TempDir()) /
         ("environment_" + std::string(test->name()) + ending);
}

std::filesystem::path picture(int width, int height, const std::string& ending = ".jpg") {
  cv::Mat image(height, width, CV_8UC3);
  cv::randu(image, 0, 255);
  const auto file = file_of(ending);
  cv::imwrite(file.string(), image);
  return file;
}

constexpr const char* kMatrix = R"(%YAML:1.0
---
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 300., 0., 499.5, 0., 310., 399.5, 0., 0., 1. ]
)";
constexpr const char* kUp = "world_from_fisheye: [ 0., 0.7071068, 0.7071068, 0. ]\n";

std::filesystem::path lens(const std::string& text) {
  const auto file = file_of(".yml");
  std::ofstream(file) << text;
  return file;
}

TEST(EnvironmentMessage, PassesJpegByteForByte) {
  const auto file = picture(64, 32);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const protocol::Envelope envelope = load_environment(file, {});
  EXPECT_EQ(envelope.environment().image(), bytes);
  EXPECT_FALSE(envelope.environment().has_fisheye());
}

TEST(EnvironmentMessage, EncodesAndShrinksEverythingElse) {
  for (const auto& file : {picture(4096, 512), picture(64, 32, ".png")}) {
    const std::string sent = load_environment(file, {}).environment().image();
    const Bytes bytes(sent.begin(), sent.end());
    EXPECT_TRUE(is_sendable_jpeg(bytes));
    EXPECT_LE(decode_image(bytes).cols, 2048);
  }
}

TEST(EnvironmentMessage, ScalesTheLensToThePicture) {
  const auto calibration = lens(std::string(kMatrix) + "image_width: 1000\nimage_height: 800\n" +
                                "max_angle_degrees: 95\n" + kUp);
  const protocol::Fisheye fisheye =
      load_environment(picture(500, 400), calibration).environment().fisheye();
  EXPECT_EQ(fisheye.width(), 500u);
  EXPECT_EQ(fisheye.height(), 400u);
  EXPECT_NEAR(fisheye.fx(), 150.0, 1e-9);
  EXPECT_NEAR(fisheye.fy(), 155.0, 1e-9);
  EXPECT_NEAR(fisheye.cx(), 249.5, 1e-9);
  EXPECT_NEAR(fisheye.max_angle(), 95.0 / 180.0 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(fisheye.world_from_fisheye().z(), 0.7071068, 1e-6);
}

// A picture that is too large is sent smaller, and its lens with it.
TEST(EnvironmentMessage, ScalesTheLensToThePictureThatIsSent) {
  const auto calibration = lens(std::string(kMatrix) + "image_width: 1000\nimage_height: 800\n" +
                                "max_angle_degrees: 95\n" + kUp);
  const protocol::Fisheye fisheye =
      load_environment(picture(2560, 2048), calibration).environment().fisheye();
  EXPECT_EQ(fisheye.width(), 2048u);
  EXPECT_EQ(fisheye.height(), 1638u);
  EXPECT_NEAR(fisheye.fx(), 300.0 * 2.048, 1e-9);
}

TEST(EnvironmentMessage, SaysWhatIsWrong) {
  const auto image = picture(1000, 800);
  const auto defect = [&](const std::string& text) {
    try {
      load_environment(image, lens(text));
      return std::string("accepted");
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  const std::string matrix = kMatrix, up = kUp;
  const auto has = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(defect(text).find(part), std::string::npos) << defect(text);
  };
  EXPECT_EQ(defect(matrix + up), "accepted");
  has("nonsense", "is not an OpenCV file");
  has("%YAML:1.0\n---\n" + up, "no camera_matrix");
  has(matrix, "world_from_fisheye must be");
  has(matrix + "world_from_fisheye: [ 0., 0., 0., 2. ]\n", "no unit quaternion");
  has(matrix + up + "max_angle_degrees: 200\n", "largest angle");
  has(matrix + up + "image_width: 500\nimage_height: 800\n", "another shape");
  has(matrix + up + "image_width: 0\nimage_height: 0\n", "another shape");
  has(matrix + up +
          "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 4\n   dt: d\n"
          "   data: [ 0., 0.1, 0., 0. ]\n",
      "equidistant");
  EXPECT_THROW(load_environment("no/such.jpg", {}), std::runtime_error);
  try {
    load_environment(testing::TempDir(), {});
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "environment " + testing::TempDir() + ": is a folder");
  }
  EXPECT_THROW(load_environment(lens("no image"), {}), std::runtime_error);
}

TEST(Connection, SendsTheEnvironmentAfterEachWelcomeAndBeforeFrames) {
  std::atomic<int> environments = 0;
  const auto script = [&](FakePeer& peer) {
    peer.welcome();
    const auto first = peer.receive();
    ASSERT_TRUE(first);
    EXPECT_TRUE(first->has_environment());
    ++environments;
    if (environments == 1) return;  // closes: the client comes back
    const auto second = peer.receive();
    ASSERT_TRUE(second);
    EXPECT_TRUE(second->has_camera_frame());
    peer.answer(second->camera_frame());
    peer.receive();
  };
  FakeServer server({script, script});
  ConnectionOptions options = server.options(3000ms);
  protocol::Envelope environment;
  environment.mutable_environment()->set_image(std::string(1'000'000, 'e'));
  options.after_welcome = protocol::encode(environment);
  Connection connection(options, hello_message(common::default_camera(64, 48), "", 0));
  int welcomes = 0;
  bool answered = false;
  for (int i = 0; i < 100 && !answered; ++i) {
    const auto event = connection.wait(100ms);
    if (!event) continue;
    if (std::holds_alternative<Welcomed>(*event) && ++welcomes == 2) {
      protocol::Envelope frame;
      frame.mutable_camera_frame()->set_frame_id(7);
      frame.mutable_camera_frame()->set_jpeg("jpeg");
      connection.send(7, protocol::encode(frame));
    }
    answered = std::holds_alternative<Composited>(*event);
  }
  EXPECT_TRUE(answered);
  EXPECT_EQ(environments, 2);
}

}  // namespace
}  // namespace amalgam::client
