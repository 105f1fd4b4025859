#include "protocol/session_record.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include "protocol/limits.h"

namespace amalgam::protocol {
namespace {

// A composite is the largest that a record holds, and little is beside it.
constexpr std::size_t kMaxLength = kMaxCompositeBytes + kMaxControlBytes;

}  // namespace

SessionRecordReader::SessionRecordReader(const std::filesystem::path& path)
    : path_(path), file_(path, std::ios::binary) {
  if (!file_) throw std::runtime_error(path.string() + ": " + std::strerror(errno));
  const auto first = next();
  if (!first || !first->has_header()) {
    throw std::runtime_error(path.string() + ": is no record of a session");
  }
  header_ = first->header();
  if (header_.format() != kRecordFormat) {
    throw std::runtime_error(path.string() + ": a record of format " +
                             std::to_string(header_.format()) + "; this program reads " +
                             std::to_string(kRecordFormat));
  }
}

std::optional<SessionRecord> SessionRecordReader::next() {
  const auto begin = static_cast<std::int64_t>(file_.tellg());
  const auto is_no_record = [&] {
    return std::runtime_error(path_.string() + ": no record at byte " + std::to_string(begin));
  };
  std::array<char, kLengthBytes> head{};
  file_.read(head.data(), head.size());
  if (file_.gcount() == 0) return std::nullopt;
  std::size_t length = 0;
  for (std::size_t i = 0; i < head.size(); ++i) {
    length |= std::size_t{static_cast<unsigned char>(head[i])} << (8 * i);
  }
  const bool has_length = static_cast<std::size_t>(file_.gcount()) == head.size();
  if (has_length && (length == 0 || length > kMaxLength)) throw is_no_record();
  std::string body(has_length ? length : 0, '\0');
  file_.read(body.data(), static_cast<std::streamsize>(body.size()));
  if (!file_) {
    cut_ = true;
    return std::nullopt;
  }
  SessionRecord record;
  if (!record.ParseFromString(body)) throw is_no_record();
  return record;
}

}  // namespace amalgam::protocol
