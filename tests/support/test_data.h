// Where the test data that is not part of the repository lies, if it is there at all.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>

namespace amalgam::tests {

// The folder AMALGAM_TEST_DATA if that is set, otherwise ../shared/data beside the source folder.
// Tests that find nothing here call GTEST_SKIP with a message.
inline std::optional<std::filesystem::path> test_data() {
  const char* named = std::getenv("AMALGAM_TEST_DATA");
  const std::filesystem::path folder =
      named != nullptr ? std::filesystem::path(named)
                       : std::filesystem::path(AMALGAM_SOURCE_DIR) / ".." / "shared" / "data";
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) return std::nullopt;
  return folder.lexically_normal();
}

}  // namespace amalgam::tests
