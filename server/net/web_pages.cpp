#include "net/web_pages.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>
#include <vector>

#include "common/hex_text.h"
#include "web/content_type.h"

namespace amalgam::net {
namespace {

constexpr std::string_view kIndex = "index.html";
// Of a file in a folder; a page is far smaller.
constexpr off_t kMaxFileBytes = off_t{64} * 1024 * 1024;

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  int get() const { return value_; }

 private:
  int value_;
};

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '_' || c == '-';
}

// The names between the slashes; empty if one of them cannot be a file's. Nothing is decoded:
// files of the page have plain names, so anything else, as %2e or .., names none.
std::vector<std::string> names_of(std::string_view path) {
  std::vector<std::string> names;
  while (!path.empty()) {
    if (path.front() != '/') return {};
    path.remove_prefix(1);
    const std::string_view name = path.substr(0, path.find('/'));
    if (name.empty() || name.front() == '.' || !std::all_of(name.begin(), name.end(), is_plain)) {
      return {};
    }
    names.emplace_back(name);
    path.remove_prefix(name.size());
  }
  return names;
}

std::string tag_of(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
  return '"' + common::hex_text(std::span(digest).first(std::min(size, 16u))) + '"';
}

// Step by step and without following links, so that nothing outside the folder can be named.
std::optional<std::string> read_below(const std::string& folder,
                                      const std::vector<std::string>& names) {
  Descriptor at(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  for (std::size_t i = 0; i < names.size() && at.get() >= 0; ++i) {
    const int kind = i + 1 < names.size() ? O_DIRECTORY : O_NONBLOCK;
    at = Descriptor(::openat(at.get(), names[i].c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | kind));
  }
  struct stat status {};
  if (at.get() < 0 || ::fstat(at.get(), &status) != 0 || !S_ISREG(status.st_mode) ||
      status.st_size > kMaxFileBytes) {
    return std::nullopt;
  }
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t size = ::read(at.get(), bytes.data() + done, bytes.size() - done);
    if (size <= 0) return std::nullopt;
    done += static_cast<std::size_t>(size);
  }
  return bytes;
}

}  // namespace

WebPage made_page(std::string_view path, std::string bytes) {
  const auto kept = std::make_shared<const std::string>(std::move(bytes));
  return {web::content_type(path), tag_of(*kept), {}, *kept, kept};
}

std::optional<WebPage> find_web_page(std::span<const web::WebFile> files, const std::string& folder,
                                     std::string_view path) {
  const std::string whole = path == "/" ? '/' + std::string(kIndex) : std::string(path);
  const std::vector<std::string> names = names_of(whole);
  if (names.empty()) return std::nullopt;
  if (!folder.empty()) {
    std::optional<std::string> bytes = read_below(folder, names);
    if (!bytes) return std::nullopt;
    std::string tag = tag_of(*bytes);
    return WebPage{web::content_type(whole), std::move(tag), std::move(*bytes), {}};
  }
  const auto file = std::find_if(files.begin(), files.end(), [&](const web::WebFile& entry) {
    return entry.path == std::string_view(whole).substr(1);
  });
  if (file == files.end()) return std::nullopt;
  return WebPage{file->content_type, std::string(file->tag), {}, file->bytes};
}

}  // namespace amalgam::net
