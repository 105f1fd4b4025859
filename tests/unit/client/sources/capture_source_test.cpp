#include "client/sources/capture_source.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/videoio.hpp>

namespace amalgam::client {
namespace {

// A film of 64 x 32 whose left half is white.
std::string film_bytes(const std::filesystem::path& file) {
  cv::VideoWriter writer(file.string(), cv::VideoWriter::fourcc('m', 'p', '4', 'v'), 10.0,
                         {64, 32});
  if (!writer.isOpened()) return {};
  cv::Mat frame(32, 64, CV_8UC3, cv::Scalar::all(0));
  frame.colRange(0, 32).setTo(cv::Scalar::all(255));
  for (int i = 0; i < 5; ++i) writer.write(frame);
  writer.release();
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Writes a b c d of the track header's matrix (ISO/IEC 14496-12, 8.3.2): x' = a x + c y and y' = b
// x
// + d y, with y pointing down, take the stored picture to the shown one.
void set_matrix(std::string& film, int a, int b, int c, int d) {
  const std::size_t matrix = film.find("tkhd") + 4 + 40;
  const auto put = [&](std::size_t index, int value) {
    const auto fixed = static_cast<std::uint32_t>(value * 0x10000);
    for (std::size_t k = 0; k < 4; ++k) {
      film[matrix + 4 * index + k] = static_cast<char>(fixed >> (24 - 8 * k));
    }
  };
  put(0, a);
  put(1, b);
  put(3, c);
  put(4, d);
}

// Films of phones, and of "ffmpeg -metadata:s:v rotate=90".
TEST(CaptureSource, FilmsAreTurnedAsTheySay) {
  const auto file = std::filesystem::path(testing::TempDir()) / "amalgam_turned.mp4";
  const std::string upright = film_bytes(file);
  if (upright.find("tkhd") == std::string::npos) GTEST_SKIP() << "no films can be written";
  struct Turn {
    int a, b, c, d;
    cv::Size size;
    cv::Point white;  // somewhere in the half that is white
  };
  for (const Turn& turn : {Turn{1, 0, 0, 1, {64, 32}, {10, 16}},      // as stored
                           Turn{0, 1, -1, 0, {32, 64}, {16, 10}},     // a quarter clockwise
                           Turn{-1, 0, 0, -1, {64, 32}, {54, 16}},    // half a turn
                           Turn{0, -1, 1, 0, {32, 64}, {16, 54}}}) {  // three quarters
    std::string film = upright;
    set_matrix(film, turn.a, turn.b, turn.c, turn.d);
    std::ofstream(file, std::ios::binary | std::ios::trunc) << film;
    CaptureSource source = CaptureSource::film(file.string(), {}, 90);
    EXPECT_EQ(source.size(), turn.size);
    for (int i = 0; i < 2; ++i) {
      const auto frame = source.next();
      ASSERT_TRUE(frame);
      ASSERT_EQ(frame->bgr.size(), turn.size);
      const cv::Point black(turn.size.width - 1 - turn.white.x,
                            turn.size.height - 1 - turn.white.y);
      EXPECT_GT(int{frame->bgr.at<cv::Vec3b>(turn.white)[0]}, 200) << turn.a << turn.b;
      EXPECT_LT(int{frame->bgr.at<cv::Vec3b>(black)[0]}, 55) << turn.a << turn.b;
    }
  }
}

}  // namespace
}  // namespace amalgam::client
