#include "report/content_hash.h"

#include <openssl/evp.h>

#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "common/hex_text.h"
#include "report/whole_file.h"

namespace amalgam::report {
namespace {

void check(int result) {
  if (result != 1) throw std::runtime_error("OpenSSL computes no SHA-256");
}

void collect_strings(const nlohmann::json& value, std::set<std::string>& strings) {
  if (value.is_string()) strings.insert(value.get<std::string>());
  if (!value.is_structured()) return;
  for (const auto& child : value) collect_strings(child, strings);
}

}  // namespace

struct ContentHash::State {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  ~State() { EVP_MD_CTX_free(context); }
};

ContentHash::ContentHash() : state_(std::make_unique<State>()) {
  check(EVP_DigestInit_ex(state_->context, EVP_sha256(), nullptr));
}

ContentHash::~ContentHash() = default;

ContentHash& ContentHash::add(std::span<const std::byte> bytes) {
  check(EVP_DigestUpdate(state_->context, bytes.data(), bytes.size()));
  return *this;
}

ContentHash& ContentHash::add(std::string_view text) {
  add(static_cast<double>(text.size()));
  return add(std::as_bytes(std::span(text)));
}

ContentHash& ContentHash::add(double number) {
  return add(std::as_bytes(std::span(&number, 1)));
}

std::string ContentHash::digest() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned size = 0;
  check(EVP_DigestFinal_ex(state_->context, bytes.data(), &size));
  return common::hex_text(std::span(bytes).first(size));
}

std::string scene_hash(const std::filesystem::path& gltf) {
  const std::string text = read_whole_file(gltf);
  ContentHash hash;
  hash.add(text);
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return hash.digest();  // a .glb holds all that it needs
  std::set<std::string> names;
  collect_strings(json, names);
  for (const std::string& name : names) {
    std::error_code error;
    const auto path = gltf.parent_path() / name;
    if (std::filesystem::is_regular_file(path, error)) hash.add(name).add(read_whole_file(path));
  }
  return hash.digest();
}

}  // namespace amalgam::report
