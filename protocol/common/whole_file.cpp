#include "common/whole_file.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace amalgam::common {
namespace {

namespace fs = std::filesystem;

// Where a link leads, so that the link stays one.
fs::path behind_links(const fs::path& target) {
  std::error_code error;
  const fs::path real = fs::canonical(target, error);
  return error ? target : real;
}

}  // namespace

std::string read_whole_file(const fs::path& path, std::size_t most_bytes) {
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(path.string() + ": " + what);
  };
  std::error_code error;
  if (fs::is_directory(path, error)) fail("is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("cannot be read");
  // By pieces and not by the file's size, which pipes do not have and files may change.
  constexpr std::size_t kPiece = std::size_t{256} << 10;
  std::string bytes;
  while (file && bytes.size() <= most_bytes) {
    const std::size_t before = bytes.size();
    // One byte more than allowed shows that there is more.
    bytes.resize(before + std::min(kPiece, most_bytes - before + 1));
    file.read(bytes.data() + before, static_cast<std::streamsize>(bytes.size() - before));
    bytes.resize(before + static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) fail("cannot be read");
  if (bytes.size() > most_bytes) fail("has more than " + std::to_string(most_bytes) + " bytes");
  return bytes;
}

void write_whole_file(const fs::path& target, const std::function<void(const fs::path&)>& write) {
  std::error_code error;
  const fs::path path = behind_links(target);
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) return write(path);
  const fs::path part =
      path.parent_path() / (".part-" + std::to_string(::getpid()) + "-" + path.filename().string());
  try {
    write(part);
    fs::rename(part, path, error);
    if (error) throw std::runtime_error(target.string() + ": " + error.message());
  } catch (...) {
    fs::remove(part, error);
    throw;
  }
}

void write_whole_file(const fs::path& target, std::string_view bytes) {
  write_whole_file(target, [&](const fs::path& path) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw std::runtime_error(target.string() + ": cannot be written");
  });
}

void check_writable(const fs::path& target) {
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(target.string() + ": " + what);
  };
  const fs::path path = behind_links(target);
  std::error_code error;
  if (fs::is_directory(path, error)) fail("is a folder");
  const bool is_direct = fs::exists(path, error) && !fs::is_regular_file(path, error);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (::access((is_direct ? path : folder).c_str(), W_OK) != 0) {
    fail("cannot be written (" + std::generic_category().message(errno) + ")");
  }
}

}  // namespace amalgam::common
