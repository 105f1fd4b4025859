#include "record/record_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cerrno>
#include <csignal>

#include "support/record_folder.h"

namespace amalgam::record {
namespace {

using test::bytes_of_file;

// A limit on the size of files, as a disk that becomes full.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }

 private:
  rlimit before_{};
};

TEST(RecordFile, IsItsOwnersAlone) {
  const test::RecordFolder folder;
  const mode_t before = ::umask(0);
  RecordFile file(folder.path() / "a");
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat((folder.path() / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

// Another session's record, or whatever else somebody put there, stays as it was.
TEST(RecordFile, TakesNoFileThatIsThere) {
  const test::RecordFolder folder;
  std::ofstream(folder.path() / "a") << "kept";
  EXPECT_THROW(RecordFile(folder.path() / "a"), std::system_error);
  EXPECT_EQ(bytes_of_file(folder.path() / "a"), "kept");
  EXPECT_THROW(RecordFile(folder.path() / "nowhere" / "a"), std::system_error);
}

TEST(RecordFile, AFullDiskIsAnError) {
  RecordFile file(::open("/dev/full", O_WRONLY | O_CLOEXEC));
  EXPECT_EQ(file.append("record"), std::errc::no_space_on_device);
  EXPECT_EQ(file.size(), 0u);
}

// The disk takes a part of the second record, and no more.
TEST(RecordFile, HasWholeRecordsWhenTheDiskBecomesFull) {
  const test::RecordFolder folder;
  const FileSizeLimit limit(10);
  RecordFile file(folder.path() / "a");
  EXPECT_FALSE(file.append("seven.."));
  EXPECT_EQ(file.append("seven.."), std::errc::file_too_large);
  EXPECT_EQ(bytes_of_file(folder.path() / "a"), "seven..");
  EXPECT_EQ(file.size(), 7u);
  EXPECT_FALSE(file.append("now"));
  EXPECT_EQ(bytes_of_file(folder.path() / "a"), "seven..now");
}

}  // namespace
}  // namespace amalgam::record
