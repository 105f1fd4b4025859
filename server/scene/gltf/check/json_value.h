// A JSON document as a tree that is safe to walk, whatever the file contains.
//
// Not a JSON library's tree, because the loader validates a glTF file before it hands it on:
// nesting is bounded while parsing, and every error names its place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/gltf/check/limits.h"

namespace amalgam::scene {

struct JsonMember;

struct JsonValue {
  enum class Kind { Null, Boolean, Number, String, Array, Object };
  Kind kind = Kind::Null;
  bool boolean = false;
  double number = 0.0;  // exact for integers up to 2^53
  std::string string;
  std::vector<JsonValue> items;     // of an array
  std::vector<JsonMember> members;  // of an object, in file order
};

struct JsonMember {
  std::string name;
  JsonValue value;
};

// Throws SceneError (without a file name) for bad syntax, a name that occurs twice in an object, a
// byte order mark, or more depth or values than the limits.
JsonValue parse_json(std::string_view text);

// A value and the path to it. Wrong kinds throw SceneError "path: what was expected". Cheap to copy
// apart from the path; valid as long as the document is.
class JsonCursor {
 public:
  explicit JsonCursor(const JsonValue& root) : value_(&root) {}
  // For a document within another one: path is where it stands there.
  JsonCursor(const JsonValue& value, std::string path) : value_(&value), path_(std::move(path)) {}

  const std::string& path() const { return path_; }
  const JsonValue& value() const { return *value_; }
  [[noreturn]] void fail(const std::string& why) const;

  // Objects.
  void expect_object() const;
  // nothing if there is no such member
  std::optional<JsonCursor> find(std::string_view name) const;
  JsonCursor get(std::string_view name) const;  // fails if there is none
  std::vector<std::pair<std::string, JsonCursor>> members() const;

  // Arrays.
  std::vector<JsonCursor> items() const;
  std::size_t size() const;                 // of items(), without making them
  std::optional<JsonCursor> front() const;  // nothing if it is empty

  // Scalars; bounds are inclusive.
  double number() const;
  double number(double low, double high) const;
  long long integer(long long low, long long high = (1LL << 53)) const;
  const std::string& string() const;
  bool boolean() const;
  std::vector<double> numbers(std::size_t count) const;  // an array of exactly `count` numbers

 private:
  const char* kind_name() const;

  const JsonValue* value_;
  std::string path_;
};

}  // namespace amalgam::scene
