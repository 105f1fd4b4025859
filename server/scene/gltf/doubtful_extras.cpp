#include "scene/gltf/doubtful_extras.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

namespace amalgam::scene {
namespace {

struct Member {
  std::string_view name;
  JsonValue::Kind kind;  // of its value
  bool of_scene;         // or of a node
};

constexpr std::array<Member, 6> kMembers{{
    {"role", JsonValue::Kind::String, false},
    {"marker", JsonValue::Kind::Number, false},
    {"world_marker", JsonValue::Kind::Number, true},
    {"dictionary", JsonValue::Kind::String, true},
    {"marker_length", JsonValue::Kind::Number, true},
    {"environment", JsonValue::Kind::String, true},
}};

// Without case, blanks and punctuation: "World Marker" is world_marker to its author.
std::string letters_of(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte)) letters += static_cast<char>(std::tolower(byte));
  }
  return letters;
}

// Letters to insert, to leave out or to change (Levenshtein), row by row.
std::size_t distance_of(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

// One slip in a short word, two in a long one. The first letter is seldom wrong, and with it "hole"
// would be a role.
bool is_slip_of(const std::string& letters, std::string_view name) {
  constexpr std::size_t kLong = 7, kLongestOfInterest = 20;
  const std::string right = letters_of(name);
  if (letters.empty() || letters.size() > kLongestOfInterest || letters[0] != right[0])
    return false;
  return distance_of(letters, right) <= (right.size() < kLong ? 1u : 2u);
}

// The member that was meant, if any. A name that is only nearly ours must also have a value of that
// member's kind: a foreign "roll" is an angle.
const Member* meant_by(const std::string& letters, JsonValue::Kind kind) {
  for (const Member& member : kMembers) {
    const bool is_exact = letters == letters_of(member.name);
    if (is_exact || (kind == member.kind && is_slip_of(letters, member.name))) return &member;
  }
  return nullptr;
}

std::optional<std::string> doubt_of(const std::string& name, const JsonCursor& at) {
  constexpr std::string_view kOurs = "amalgam";
  std::string letters = letters_of(name);
  const bool has_prefix = letters.starts_with(kOurs);
  if (has_prefix) letters.erase(0, kOurs.size());
  const Member* meant = meant_by(letters, at.value().kind);
  if (!meant && !has_prefix && !is_slip_of(letters, kOurs)) return std::nullopt;
  std::string doubt =
      at.path() + ": is not read; \"extras\": {\"amalgam\": {...}} holds what is ours";
  if (meant) {
    doubt += ", as {\"" + std::string(meant->name) + "\": ...} at a " +
             (meant->of_scene ? "scene" : "node");
  }
  return doubt;
}

}  // namespace

std::vector<std::string> doubtful_extras(const JsonCursor& root) {
  std::vector<std::string> doubts;
  bool any = false;
  for (const char* collection : {"scenes", "nodes", "meshes", "materials", "cameras"}) {
    const auto elements = root.find(collection);
    if (!elements) continue;
    const std::string_view kind = collection;
    const bool may_have_ours = kind == "scenes" || kind == "nodes";
    for (const JsonCursor& element : elements->items()) {
      const auto extras = element.find("extras");
      if (!extras || extras->value().kind != JsonValue::Kind::Object) continue;
      for (const auto& [name, at] : extras->members()) {
        if (name != "amalgam" && name != "is_shadow_catcher") {
          if (auto doubt = doubt_of(name, at)) doubts.push_back(*std::move(doubt));
        } else if (may_have_ours) {
          any = true;
        } else {
          doubts.push_back(at.path() + ": is not read here, only at nodes and scenes");
        }
      }
    }
  }
  if (!any) {
    doubts.emplace_back(
        "no \"extras\": {\"amalgam\": ...} in the file: all of it is virtual, on marker 0 of "
        "DICT_6X6_250 with 0.05 m");
  }
  return doubts;
}

}  // namespace amalgam::scene
