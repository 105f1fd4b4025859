// SHA-256, to tell whether two things are the same thing. By OpenSSL.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace amalgam::report {

class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  ContentHash(const ContentHash&) = delete;
  ContentHash& operator=(const ContentHash&) = delete;

  ContentHash& add(std::span<const std::byte> bytes);
  // Ends with a mark of its own, so that "ab", "c" and "a", "bc" differ.
  ContentHash& add(std::string_view text);
  // To the last bit.
  ContentHash& add(double number);

  // Hexadecimal, 64 digits. May be called once.
  std::string digest();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Of a glTF file and of every file that a string in it names: buffers, textures, environment.
// Throws std::runtime_error.
std::string scene_hash(const std::filesystem::path& gltf);

}  // namespace amalgam::report
