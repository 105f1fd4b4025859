#include "scene/gltf/check/json_value.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

// Receives nlohmann's parse events and builds the tree without recursion.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TreeBuilder(JsonValue& root) : root_(root) {}

  bool null() override { return place({}); }
  bool boolean(bool value) override {
    JsonValue made;
    made.kind = JsonValue::Kind::Boolean;
    made.boolean = value;
    return place(std::move(made));
  }
  bool number_integer(number_integer_t value) override {
    return place_number(static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return place_number(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return place_number(value); }
  bool string(string_t& value) override {
    JsonValue made;
    made.kind = JsonValue::Kind::String;
    made.string = std::move(value);
    return place(std::move(made));
  }
  bool binary(binary_t&) override { throw SceneError("invalid JSON: binary value"); }
  bool start_object(std::size_t) override { return open(JsonValue::Kind::Object); }
  bool start_array(std::size_t) override { return open(JsonValue::Kind::Array); }
  bool end_object() override {
    refuse_repeated_names(open_.back()->members);
    return close();
  }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    key_ = std::move(value);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception&) override {
    throw SceneError("invalid JSON at byte " + std::to_string(position));
  }

 private:
  static void refuse_repeated_names(const std::vector<JsonMember>& members) {
    std::vector<std::string_view> names;
    for (const auto& member : members) names.push_back(member.name);
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice == names.end()) return;
    throw SceneError("invalid JSON: '" + std::string(*twice) + "' occurs twice in an object");
  }

  bool place_number(double value) {
    JsonValue made;
    made.kind = JsonValue::Kind::Number;
    made.number = value;
    return place(std::move(made));
  }

  bool place(JsonValue value) {
    put(std::move(value));
    return true;
  }

  JsonValue& put(JsonValue value) {
    if (++count_ > kMaxJsonValues) throw SceneError("JSON has more than 4 million values");
    if (open_.empty()) return root_ = std::move(value);
    JsonValue& parent = *open_.back();
    if (parent.kind == JsonValue::Kind::Array) return parent.items.emplace_back(std::move(value));
    parent.members.push_back({std::move(key_), std::move(value)});
    return parent.members.back().value;
  }

  bool open(JsonValue::Kind kind) {
    if (open_.size() == kMaxJsonDepth) throw SceneError("JSON is nested more than 64 deep");
    JsonValue made;
    made.kind = kind;
    // The pointer stays good: its parent gets no further element before this one is closed.
    open_.push_back(&put(std::move(made)));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  JsonValue& root_;
  std::vector<JsonValue*> open_;
  std::string key_;
  std::size_t count_ = 0;
};

}  // namespace

JsonValue parse_json(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF"))
    throw SceneError("invalid JSON: begins with a byte order mark");
  JsonValue root;
  TreeBuilder builder(root);
  nlohmann::json::sax_parse(text, &builder);
  return root;
}

void JsonCursor::fail(const std::string& why) const {
  throw SceneError(path_.empty() ? why : path_ + ": " + why);
}

const char* JsonCursor::kind_name() const {
  switch (value_->kind) {
    case JsonValue::Kind::Null:
      return "null";
    case JsonValue::Kind::Boolean:
      return "a boolean";
    case JsonValue::Kind::Number:
      return "a number";
    case JsonValue::Kind::String:
      return "a string";
    case JsonValue::Kind::Array:
      return "an array";
    case JsonValue::Kind::Object:
      break;
  }
  return "an object";
}

void JsonCursor::expect_object() const {
  if (value_->kind != JsonValue::Kind::Object)
    fail(std::string("expected an object, not ") + kind_name());
}

std::optional<JsonCursor> JsonCursor::find(std::string_view name) const {
  expect_object();
  for (const auto& [member_name, member] : value_->members) {
    if (member_name == name) {
      return JsonCursor(member, path_.empty() ? member_name : path_ + "." + member_name);
    }
  }
  return std::nullopt;
}

JsonCursor JsonCursor::get(std::string_view name) const {
  auto found = find(name);
  if (!found) fail("has no '" + std::string(name) + "'");
  return *std::move(found);
}

std::vector<std::pair<std::string, JsonCursor>> JsonCursor::members() const {
  expect_object();
  std::vector<std::pair<std::string, JsonCursor>> all;
  for (const auto& [name, member] : value_->members) {
    all.emplace_back(name, JsonCursor(member, path_.empty() ? name : path_ + "." + name));
  }
  return all;
}

std::size_t JsonCursor::size() const {
  if (value_->kind != JsonValue::Kind::Array)
    fail(std::string("expected an array, not ") + kind_name());
  return value_->items.size();
}

std::optional<JsonCursor> JsonCursor::front() const {
  if (size() == 0) return std::nullopt;
  return JsonCursor(value_->items.front(), path_ + "[0]");
}

std::vector<JsonCursor> JsonCursor::items() const {
  std::vector<JsonCursor> all;
  all.reserve(size());
  for (std::size_t i = 0; i < value_->items.size(); ++i) {
    all.push_back(JsonCursor(value_->items[i], path_ + "[" + std::to_string(i) + "]"));
  }
  return all;
}

double JsonCursor::number() const {
  if (value_->kind != JsonValue::Kind::Number)
    fail(std::string("expected a number, not ") + kind_name());
  if (!std::isfinite(value_->number)) fail("is not finite");
  return value_->number;
}

double JsonCursor::number(double low, double high) const {
  const double n = number();
  if (!(n >= low && n <= high)) {
    fail(nlohmann::json(n).dump() + " is not within " + nlohmann::json(low).dump() + " and " +
         nlohmann::json(high).dump());
  }
  return n;
}

long long JsonCursor::integer(long long low, long long high) const {
  const double n = number();
  if (n != std::floor(n)) fail("expected an integer");
  if (n < static_cast<double>(low) || n > static_cast<double>(high)) {
    fail(nlohmann::json(n).dump() + " is not within " + std::to_string(low) + " and " +
         std::to_string(high));
  }
  return static_cast<long long>(n);
}

const std::string& JsonCursor::string() const {
  if (value_->kind != JsonValue::Kind::String)
    fail(std::string("expected a string, not ") + kind_name());
  return value_->string;
}

bool JsonCursor::boolean() const {
  if (value_->kind != JsonValue::Kind::Boolean)
    fail(std::string("expected a boolean, not ") + kind_name());
  return value_->boolean;
}

std::vector<double> JsonCursor::numbers(std::size_t count) const {
  const auto all = items();
  if (all.size() != count) fail("expected " + std::to_string(count) + " numbers");
  std::vector<double> values;
  for (const JsonCursor& item : all) values.push_back(item.number());
  return values;
}

}  // namespace amalgam::scene
