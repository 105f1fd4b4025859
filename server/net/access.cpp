#include "net/access.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <array>
#include <stdexcept>

#include "common/token_file.h"
#include "protocol/limits.h"

namespace amalgam::net {
namespace {

using Digest = std::array<unsigned char, 32>;

// Digests have one length, so that not even the length of a secret shows in the time.
Digest sha256(std::string_view text) {
  Digest digest{};
  if (EVP_Digest(text.data(), text.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 failed");
  }
  return digest;
}

}  // namespace

std::vector<Grant> read_grants(const std::string& path) {
  std::vector<Grant> grants;
  for (common::TokenLine& line : common::read_token_lines(path, protocol::kMaxTokenBytes)) {
    Rights rights;
    if (line.rights.empty()) rights = {.view = true, .environment = true};
    for (const std::string& right : line.rights) {
      if (right == "view") {
        rights.view = true;
      } else if (right == "environment") {
        rights.view = rights.environment = true;
      } else {
        // Not quoted: it may be a part of a token.
        throw std::runtime_error("the token file " + path + " gives a right in line " +
                                 std::to_string(line.number) +
                                 " that is none of view, environment");
      }
    }
    grants.push_back({std::move(line.token), rights});
  }
  return grants;
}

std::optional<Rights> rights_of(std::string_view given, const std::vector<Grant>& grants) {
  if (grants.empty()) return Rights{.view = true, .environment = true};
  const Digest digest = sha256(given);
  std::optional<Rights> found;
  // All are compared, whichever is the right one.
  for (const Grant& grant : grants) {
    const Digest expected = sha256(grant.token);
    if (CRYPTO_memcmp(digest.data(), expected.data(), digest.size()) == 0) found = grant.rights;
  }
  return found;
}

}  // namespace amalgam::net
