#include "common/whole_file.h"

#include <unistd.h>

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

}  // namespace amalgam::common
