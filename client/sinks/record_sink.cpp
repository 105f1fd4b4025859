#include <opencv2/videoio.hpp>
#include <stdexcept>

#include "client/sinks/frame_sink.h"
#include "client/sources/jpeg_bytes.h"

namespace amalgam::client {
namespace {

class RecordSink : public FrameSink {
 public:
  RecordSink(const std::filesystem::path& file, double rate) : file_(file), rate_(rate) {
    if (file.extension() != ".mp4") throw std::runtime_error("--record: the file must be a .mp4");
  }

  void show(std::uint64_t, std::span<const unsigned char> jpeg) override {
    const cv::Mat image = decode_image(jpeg);
    if (image.empty()) throw std::runtime_error("--record: a composite cannot be decoded");
    if (!writer_.isOpened() &&
        !writer_.open(file_.string(), cv::VideoWriter::fourcc('m', 'p', '4', 'v'), rate_,
                      image.size())) {
      throw std::runtime_error("--record: " + file_.string() + " cannot be written");
    }
    writer_.write(image);
  }

 private:
  std::filesystem::path file_;
  double rate_;
  cv::VideoWriter writer_;
};

}  // namespace

std::unique_ptr<FrameSink> make_record_sink(const std::filesystem::path& file, double rate) {
  return std::make_unique<RecordSink>(file, rate);
}

}  // namespace amalgam::client
