// A file that grows by whole records, and by nothing if the disk is full.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

namespace amalgam::record {

class RecordFile {
 public:
  // Makes a new file that only its owner may read or write. Throws std::system_error.
  explicit RecordFile(const std::string& path);
  // Takes over an open descriptor.
  explicit RecordFile(int descriptor) : descriptor_(descriptor) {}
  ~RecordFile();
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  // All of the bytes or, with an error, none. Not synchronised with the disk: what was appended
  // survives the process's death, though not the machine's.
  std::error_code append(std::string_view bytes);

  std::uint64_t size() const { return size_; }

 private:
  int descriptor_;
  std::uint64_t size_ = 0;
};

}  // namespace amalgam::record
