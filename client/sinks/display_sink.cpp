#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <opencv2/highgui.hpp>
#include <stdexcept>

#include "client/sinks/frame_sink.h"
#include "client/sources/jpeg_bytes.h"

namespace amalgam::client {
namespace {

constexpr const char* kWindow = "Amalgam";
constexpr int kEscape = 27;

// Some window libraries end the program if they cannot reach the display, so a child process tries
// first. Must be called before threads are started.
bool window_opens_elsewhere() {
  const pid_t child = ::fork();
  if (child < 0) return true;  // then it is found out the hard way
  if (child == 0) {
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
    try {
      cv::namedWindow(kWindow, cv::WINDOW_AUTOSIZE);
    } catch (...) {
      ::_exit(EXIT_FAILURE);
    }
    ::_exit(EXIT_SUCCESS);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

class DisplaySink : public FrameSink {
 public:
  DisplaySink() {
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
      throw std::runtime_error("--display: there is no display (DISPLAY is not set)");
    }
    if (!window_opens_elsewhere()) {
      throw std::runtime_error("--display: the display cannot be reached or shows no windows");
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
