#include "record/record_folder.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <system_error>

namespace amalgam::record {

namespace fs = std::filesystem;

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

std::string record_path(const std::string& folder, std::uint64_t session) {
  std::string name = utc_now();
  std::erase_if(name, [](char c) { return c == '-' || c == ':'; });  // as some systems want it
  for (const auto number : {static_cast<std::uint64_t>(::getpid()), session}) {
    name.append("-").append(std::to_string(number));
  }
  return fs::path(folder) / name.append(kRecordExtension);
}

std::uint64_t bytes_of_records(const std::string& folder) {
  std::uint64_t bytes = 0;
  std::error_code error;
  for (fs::directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error)) {
    if (file->path().extension() != kRecordExtension) continue;
    std::error_code gone;  // an operator may tidy up meanwhile
    const std::uintmax_t size = file->file_size(gone);
    if (!gone) bytes += size;
  }
  return bytes;
}

}  // namespace amalgam::record
