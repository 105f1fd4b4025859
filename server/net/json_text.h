// JSON as text. Not nlohmann's objects, whose destructors allocate: where memory is missing they
// end the process, and somebody who asks for a page must not be able to bring that about.
#pragma once

#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

namespace amalgam::net {

// Bytes that are no UTF-8 are replaced.
std::string json_string(const std::string& text);

class JsonObject {
 public:
  void add(std::string_view key, const std::string& text) { add_raw(key, json_string(text)); }
  void add(std::string_view key, const char* text) { add(key, std::string(text)); }
  void add(std::string_view key, bool value) { add_raw(key, value ? "true" : "false"); }
  template <std::integral Number>
  void add(std::string_view key, Number value) {
    add_raw(key, std::to_string(value));
  }
  // JSON knows neither infinity nor what is not a number.
  void add(std::string_view key, double value) {
    add_raw(key, std::isfinite(value) ? std::to_string(value) : "null");
  }
  void add_raw(std::string_view key, const std::string& json) {
    text_.append(text_.empty() ? "{" : ", ").append("\"").append(key).append("\": ").append(json);
  }
  std::string end() const { return text_.empty() ? "{}" : text_ + "}"; }

 private:
  std::string text_;
};

class JsonArray {
 public:
  // before_each: white space, as a new line, before each element.
  explicit JsonArray(std::string_view before_each = "") : before_each_(before_each) {}
  void add_raw(const std::string& json) {
    text_.append(text_.empty() ? "" : ",").append(before_each_).append(json);
  }
  std::string end() const { return "[" + text_ + "]"; }

 private:
  std::string_view before_each_;
  std::string text_;
};

}  // namespace amalgam::net
