#include "scene/gltf/scene_hash.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <memory>
#include <span>

#include "common/hex_text.h"
#include "scene/gltf/check/json_value.h"
#include "scene/gltf/check/uri.h"
#include "scene/gltf/container.h"
#include "scene/gltf/scene_folder.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

namespace fs = std::filesystem;

class Files {
 public:
  explicit Files(const fs::path& scene) : folder_(scene), found_{scene} {}

  // Buffers and pictures are named by "uri", the environment by its own name, wherever they stand.
  void add_named_in(const JsonValue& value) {
    for (const JsonValue& item : value.items) add_named_in(item);
    for (const JsonMember& member : value.members) {
      add_named_in(member.value);
      if (member.value.kind != JsonValue::Kind::String) continue;
      if (member.name == "uri" || member.name == "environment") add(member.value);
      // Blender exports our properties as a text that is JSON.
      if (member.name == "amalgam") add_named_in(parse_json(member.value.string));
    }
  }

  const std::vector<fs::path>& found() const { return found_; }

 private:
  // By the names under which the loader looks for it.
  void add(const JsonValue& name) {
    if (is_data_uri(name.string)) return;
    const std::string decoded = decode_percent(JsonCursor(name));
    std::string with_slashes = decoded;
    std::ranges::replace(with_slashes, '\\', '/');
    for (const std::string& text : {decoded, name.string, with_slashes}) {
      try {
        const fs::path path = folder_.resolve(text);
        if (std::ranges::find(found_, path) == found_.end()) found_.push_back(path);
        return;
      } catch (const SceneError&) {
        continue;
      }
    }
  }

  SceneFolder folder_;
  std::vector<fs::path> found_;
};

}  // namespace

std::vector<fs::path> files_of_scene(const fs::path& path) {
  const std::vector<std::byte> file = read_file(path, kMaxFileBytes);
  std::vector<std::string> notes;
  std::string_view json = open_gltf_container(file, path.extension() == ".glb", notes).json;
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (json.starts_with(kByteOrderMark)) json.remove_prefix(kByteOrderMark.size());
  Files files(path);
  files.add_named_in(parse_json(json));
  return files.found();
}

std::string scene_hash(const fs::path& path) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> hash(EVP_MD_CTX_new(),
                                                                     &EVP_MD_CTX_free);
  EVP_DigestInit_ex(hash.get(), EVP_sha256(), nullptr);
  for (const fs::path& file : files_of_scene(path)) {
    const std::vector<std::byte> bytes = read_file(file, kMaxFileBytes);
    // Also the size, so that bytes cannot move from one file to the next unnoticed.
    const std::uint64_t size = bytes.size();
    EVP_DigestUpdate(hash.get(), &size, sizeof size);
    EVP_DigestUpdate(hash.get(), bytes.data(), bytes.size());
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  EVP_DigestFinal_ex(hash.get(), digest.data(), &size);
  return common::hex_text(std::span(digest).first(size));
}

}  // namespace amalgam::scene
