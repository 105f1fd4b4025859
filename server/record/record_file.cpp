#include "record/record_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace amalgam::record {

RecordFile::RecordFile(const std::string& path)
    : descriptor_(::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_EXCL | O_CLOEXEC, 0600)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), path);
}

RecordFile::~RecordFile() {
  ::close(descriptor_);
}

std::error_code RecordFile::append(std::string_view bytes) {
  std::string_view left = bytes;
  while (!left.empty()) {
    const ssize_t written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const std::error_code error(errno, std::generic_category());
      // The begun record goes again. If even that fails, readers stop where it begins.
      static_cast<void>(::ftruncate(descriptor_, static_cast<off_t>(size_)));
      return error;
    }
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  size_ += bytes.size();
  return {};
}

}  // namespace amalgam::record
