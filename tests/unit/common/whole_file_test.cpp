#include "common/whole_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace amalgam::common {
namespace {

namespace fs = std::filesystem;

class WholeFile : public testing::Test {
 protected:
  WholeFile() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }

  const fs::path folder_ =
      fs::path(testing::TempDir()) / ("amalgam_whole_file_" + std::to_string(getpid()));
  const fs::path file_ = folder_ / "picture.png";
};

TEST_F(WholeFile, IsWritten) {
  write_whole_file(file_, "first");
  write_whole_file(file_, "second");
  EXPECT_EQ(read(file_), "second");
  EXPECT_EQ(files(), 1u);
}

TEST_F(WholeFile, AFailureLeavesWhatWasThere) {
  write_whole_file(file_, "before");
  const auto half = [](const fs::path& path) {
    EXPECT_EQ(path.extension(), ".png");
    std::ofstream(path) << "half";
    throw std::runtime_error("disk full");
  };
  EXPECT_THROW(write_whole_file(file_, half), std::runtime_error);
  EXPECT_EQ(read(file_), "before");
  EXPECT_THROW(write_whole_file(folder_ / "new.png", half), std::runtime_error);
  EXPECT_EQ(files(), 1u);
}

TEST_F(WholeFile, ErrorsNameTheTarget) {
  try {
    write_whole_file(folder_ / "missing" / "a.png", "bytes");
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), (folder_ / "missing" / "a.png").string() + ": cannot be written");
  }
}

// /dev/null must not be replaced by a file, and /dev/full must be noticed.
TEST_F(WholeFile, DevicesAreWrittenDirectly) {
  write_whole_file("/dev/null", "bytes");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_THROW(write_whole_file("/dev/full", std::string(100000, 'x')), std::runtime_error);
}

TEST_F(WholeFile, LinksStayLinks) {
  fs::create_symlink(file_, folder_ / "link.png");
  write_whole_file(file_, "old");
  write_whole_file(folder_ / "link.png", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.png"));
  EXPECT_EQ(read(file_), "new");
}

}  // namespace
}  // namespace amalgam::common
