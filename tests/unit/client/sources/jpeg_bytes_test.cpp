#include "client/sources/jpeg_bytes.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

namespace amalgam::client {
namespace {

// Bytes at the very end of the memory that may be read: one more ends the test program.
class AtTheEnd {
 public:
  explicit AtTheEnd(const std::vector<unsigned char>& bytes)
      : page_(static_cast<std::size_t>(::sysconf(_SC_PAGESIZE))) {
    void* const memory =
        ::mmap(nullptr, 2 * page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("no memory");
    memory_ = static_cast<unsigned char*>(memory);
    ::mprotect(memory_ + page_, page_, PROT_NONE);
    bytes_ = std::span(memory_ + page_ - bytes.size(), bytes.size());
    std::ranges::copy(bytes, bytes_.begin());
  }
  ~AtTheEnd() { ::munmap(memory_, 2 * page_); }
  AtTheEnd(const AtTheEnd&) = delete;
  AtTheEnd& operator=(const AtTheEnd&) = delete;

  std::span<const unsigned char> bytes() const { return bytes_; }

 private:
  std::size_t page_;
  unsigned char* memory_ = nullptr;
  std::span<unsigned char> bytes_;
};

// Start of image, and the header of a baseline frame of 16x16 pixels with this many components, of
// which some are described.
std::vector<unsigned char> header(unsigned char components, int described,
                                  unsigned char luma = 0x22) {
  const auto length = static_cast<unsigned char>(8 + 3 * described);
  std::vector<unsigned char> bytes{0xFF, 0xD8, 0xFF, 0xC0, 0, length, 8, 0, 16, 0, 16, components};
  for (int i = 0; i < described; ++i) {
    bytes.push_back(static_cast<unsigned char>(i + 1));
    bytes.push_back(i == 0 ? luma : 0x11);
    bytes.push_back(0);
  }
  return bytes;
}

TEST(JpegBytes, HeadersAreReadToTheirEndAndNoFurther) {
  EXPECT_TRUE(is_sendable_jpeg(AtTheEnd(header(1, 1)).bytes()));
  EXPECT_TRUE(is_sendable_jpeg(AtTheEnd(header(3, 3)).bytes()));
  EXPECT_FALSE(is_sendable_jpeg(AtTheEnd(header(3, 3, 0x41)).bytes()));
  for (const int components : {0, 2, 3, 4, 255}) {
    for (const int described : {0, 1, 2, 4}) {
      const auto bytes = header(static_cast<unsigned char>(components), described);
      const bool fits = components == 3 && described == 4;  // with a few bytes behind
      EXPECT_EQ(is_sendable_jpeg(AtTheEnd(bytes).bytes()), fits) << components << " " << described;
    }
  }
}

}  // namespace
}  // namespace amalgam::client
