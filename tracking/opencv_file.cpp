#include "tracking/opencv_file.h"

#include <stdexcept>

#include "common/whole_file.h"
#include "tracking/text_nesting.h"

namespace amalgam::tracking {
namespace {

constexpr std::size_t kMaxFileBytes = 1 << 20;  // a calibration has a few kB, even with its points

}  // namespace

void fail_file(const char* kind, const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(std::string(kind) + " " + file.string() + ": " + what);
}

std::string first_line(const cv::Exception& error) {
  return error.err.substr(0, error.err.find('\n'));
}

std::string read_small_text(const char* kind, const std::filesystem::path& file) {
  std::string text;
  try {
    text = common::read_whole_file(file, kMaxFileBytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(kind) + " " + error.what());
  }
  if (text.empty()) fail_file(kind, file, "is empty");
  if (may_nest_too_deeply(text)) fail_file(kind, file, "is nested too deeply");
  return text;
}

}  // namespace amalgam::tracking
