#include <cstdlib>
#include <opencv2/highgui.hpp>
#include <stdexcept>

#include "client/frame_sink.h"
#include "client/jpeg_bytes.h"

namespace amalgam::client {
namespace {

constexpr const char* kWindow = "Amalgam";
constexpr int kEscape = 27;

class DisplaySink : public FrameSink {
 public:
  DisplaySink() {
    // Asked first: some window libraries end the program when there is no display.
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
      throw std::runtime_error("--display: there is no display (DISPLAY is not set)");
    }
    try {
      cv::namedWindow(kWindow, cv::WINDOW_AUTOSIZE);
    } catch (const cv::Exception&) {
      throw std::runtime_error("--display: no window can be opened");
    }
  }
  ~DisplaySink() override {
    try {
      cv::destroyWindow(kWindow);
    } catch (const cv::Exception&) {  // closed by the user already
    }
  }

  void show(std::uint64_t, std::span<const unsigned char> jpeg) override {
    const cv::Mat image = decode_image(jpeg);
    if (image.empty()) throw std::runtime_error("--display: a composite cannot be decoded");
    cv::imshow(kWindow, image);
  }

  bool wants_to_stop() override {
    const int key = cv::pollKey();
    return key == 'q' || key == kEscape;
  }
};

}  // namespace

std::unique_ptr<FrameSink> make_display_sink() {
  return std::make_unique<DisplaySink>();
}

}  // namespace amalgam::client
