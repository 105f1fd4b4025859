// A folder for the records of a test's sessions, and what is in them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "protocol/session_record.h"

namespace amalgam::test {

inline std::string bytes_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class RecordFolder {
 public:
  RecordFolder() {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~RecordFolder() { std::filesystem::remove_all(path_); }
  RecordFolder(const RecordFolder&) = delete;
  RecordFolder& operator=(const RecordFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  // By session, because their numbers end their names.
  std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      if (entry.path().extension() == ".session") files.push_back(entry.path());
    }
    const auto session = [](const std::filesystem::path& path) {
      const std::string name = path.stem();
      return std::stoull(name.substr(name.rfind('-') + 1));
    };
    std::ranges::sort(files, {}, session);
    return files;
  }

  // All records of a file behind its header.
  static std::vector<protocol::SessionRecord> read(const std::filesystem::path& file) {
    protocol::SessionRecordReader reader(file);
    std::vector<protocol::SessionRecord> records;
    while (auto record = reader.next()) records.push_back(std::move(*record));
    return records;
  }

  // Waits until so many records have been closed, and returns their files.
  std::vector<std::filesystem::path> closed(std::size_t count) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < end) {
      const auto all = files();
      const auto is_closed = [](const auto& file) {
        try {
          const auto records = read(file);
          return !records.empty() && records.back().has_end();
        } catch (const std::runtime_error&) {  // its first record is being written
          return false;
        }
      };
      if (all.size() >= count && std::ranges::all_of(all, is_closed)) return all;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ADD_FAILURE() << "no " << count << " closed records within ten seconds";
    return files();
  }

 private:
  const std::filesystem::path path_ =
      std::filesystem::path(testing::TempDir()) / ("amalgam_records_" + std::to_string(::getpid()));
};

}  // namespace amalgam::test
