// Reads the small text files that OpenCV's cv::FileStorage understands, with errors of one line.
#pragma once

#include <filesystem>
#include <opencv2/core/utility.hpp>
#include <string>

namespace amalgam::tracking {

// Keeps OpenCV from printing errors before it throws them; the program prints them once.
class QuietOpenCv {
 public:
  QuietOpenCv() : previous_(cv::redirectError(ignore)) {}
  ~QuietOpenCv() { cv::redirectError(previous_); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  static int ignore(int, const char*, const char*, const char*, int, void*) { return 0; }
  cv::ErrorCallback previous_;
};

// kind: of file, for the error: "calibration", "board".
[[noreturn]] void fail_file(const char* kind, const std::filesystem::path& file,
                            const std::string& what);

// The first line of what OpenCV says.
std::string first_line(const cv::Exception& error);

// The whole file, at most 1 MiB, and not nested too deeply for OpenCV's parsers. Throws
// std::runtime_error.
std::string read_small_text(const char* kind, const std::filesystem::path& file);

}  // namespace amalgam::tracking
