#include "net/token.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <stdexcept>

#include "protocol/limits.h"

namespace amalgam::net {
namespace {

using Digest = std::array<unsigned char, 32>;

Digest sha256(std::string_view text) {
  Digest digest{};
  if (EVP_Digest(text.data(), text.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 failed");
  }
  return digest;
}

}  // namespace

std::string read_token_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read the token file " + path.string());
  // One byte more than allowed shows that there is more, whatever the size of the file.
  std::string text(protocol::kMaxTokenBytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > protocol::kMaxTokenBytes) {
    throw std::runtime_error("the token file " + path.string() + " holds more than " +
                             std::to_string(protocol::kMaxTokenBytes) + " bytes");
  }
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string::npos) {
    throw std::runtime_error("the token file " + path.string() + " is empty");
  }
  return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

bool tokens_equal(std::string_view given, std::string_view expected) {
  // Digests have one length, so that not even the length of the secret shows in the time.
  const Digest a = sha256(given);
  const Digest b = sha256(expected);
  return CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace amalgam::net
