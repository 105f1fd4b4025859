#include "report/whole_file.h"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace amalgam::report {

namespace fs = std::filesystem;

void write_whole_file(const fs::path& path, std::string_view content) {
  write_whole_file(path, [&](const fs::path& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) throw std::runtime_error(path.string() + " cannot be written");
  });
}

void write_whole_file(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  fs::path temporary = path.parent_path() / path.stem();
  temporary += ".part-" + std::to_string(getpid()) + path.extension().string();
  std::error_code error;
  try {
    write(temporary);
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
  fs::rename(temporary, path, error);
  if (error) throw std::runtime_error(path.string() + ": " + error.message());
}

std::string read_whole_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path.string() + " cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace amalgam::report
