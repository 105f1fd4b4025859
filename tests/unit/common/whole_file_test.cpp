#include "common/whole_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <thread>

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

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

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

TEST_F(WholeFile, IsReadToItsEndIfItIsNotTooLarge) {
  const std::string bytes = std::string(300'000, 'a') + '\0' + std::string(300'000, 'b');
  write_whole_file(file_, bytes);
  EXPECT_EQ(read_whole_file(file_, bytes.size()), bytes);
  EXPECT_EQ(read_whole_file(file_, 1 << 30), bytes);
  EXPECT_EQ(error_of([&] { read_whole_file(file_, bytes.size() - 1); }),
            file_.string() + ": has more than 600000 bytes");
  write_whole_file(file_, "");
  EXPECT_EQ(read_whole_file(file_, 0), "");
}

// Neither has a size that it says.
TEST_F(WholeFile, PipesAndFilesOfTheKernelAreRead) {
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(file_) << std::string(500'000, 'x'); });
  EXPECT_EQ(read_whole_file(file_, 1 << 20).size(), 500'000u);
  writer.join();
  EXPECT_NE(read_whole_file("/proc/self/status", 1 << 20).find("Pid:"), std::string::npos);
}

TEST_F(WholeFile, WhatCannotBeReadIsSaid) {
  const auto error = [](const fs::path& path) {
    return error_of([&] { read_whole_file(path, 100); });
  };
  EXPECT_EQ(error(folder_), folder_.string() + ": is a folder");
  EXPECT_EQ(error(folder_ / "missing"), (folder_ / "missing").string() + ": cannot be read");
  EXPECT_EQ(error("/proc/self/mem"), "/proc/self/mem: cannot be read");
}

TEST_F(WholeFile, WhatCannotBeWrittenIsSaidBefore) {
  check_writable(file_);
  check_writable("picture.png");  // of the current folder
  check_writable("/dev/null");
  EXPECT_EQ(files(), 0u);
  EXPECT_EQ(error_of([&] { check_writable(folder_); }), folder_.string() + ": is a folder");
  const fs::path lost = folder_ / "missing" / "a.png";
  EXPECT_EQ(error_of([&] { check_writable(lost); }),
            lost.string() + ": cannot be written (No such file or directory)");
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
