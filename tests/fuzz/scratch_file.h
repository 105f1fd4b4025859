// A file for what is only read by name. TMPDIR should be in memory.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "bench/povray/temporary_folder.h"
#include "common/log.h"

namespace amalgam::fuzz {

class ScratchFile {
 public:
  explicit ScratchFile(const std::string& name) : path_(folder_.path() / name) {}

  const std::filesystem::path& path() const { return path_; }

  const std::filesystem::path& write(std::string_view content) const {
    std::ofstream file(path_, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    AMALGAM_CHECK(file, path_.string() + " cannot be written");
    return path_;
  }

 private:
  bench::TemporaryFolder folder_;
  std::filesystem::path path_;
};

}  // namespace amalgam::fuzz
