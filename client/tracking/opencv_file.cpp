#include "client/tracking/opencv_file.h"

#include <fstream>
#include <stdexcept>

namespace amalgam::client {
namespace {

constexpr std::size_t kMaxFileBytes = 1 << 20;  // a calibration has a few kB, even with its points

}  // namespace

void fail_file(const char* kind, const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(std::string(kind) + " " + file.string() + ": " + what);
}

std::string read_small_text(const char* kind, const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) fail_file(kind, file, "no such file");
  std::ifstream in(file, std::ios::binary);
  std::string text(kMaxFileBytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad() || (!in && !in.eof())) fail_file(kind, file, "cannot be read");
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.empty()) fail_file(kind, file, "is empty or cannot be read");
  if (text.size() > kMaxFileBytes) {
    fail_file(kind, file, std::string("is larger than 1 MiB, so not a ") + kind);
  }
  return text;
}

}  // namespace amalgam::client
