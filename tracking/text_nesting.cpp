#include "tracking/text_nesting.h"

#include <cctype>
#include <cstddef>

namespace amalgam::tracking {
namespace {

constexpr std::size_t kMostLevels = 5000;  // a board of 1024 markers in one line of JSON has 4100

// Brackets of YAML and JSON, elements of XML.
class OpenLevels {
 public:
  void take(char c, char next) {
    const bool is_element =
        c == '<' && (std::isalpha(static_cast<unsigned char>(next)) != 0 || next == '_');
    if (c == '[' || c == '{' || is_element) ++closable_;
    const bool is_end =
        c == ']' || c == '}' || (c == '<' && next == '/') || (c == '/' && next == '>');
    if (is_end && closable_ > 0) --closable_;
    const bool begins_text = c == '"' || c == '\'' || c == '#' || (c == '<' && next == '!') ||
                             (c == '/' && (next == '/' || next == '*'));
    // An end that comes now may be part of a string or of a comment.
    if (begins_text) {
      kept_ += closable_;
      closable_ = 0;
    }
  }
  std::size_t count() const { return kept_ + closable_; }

 private:
  std::size_t closable_ = 0, kept_ = 0;
};

// Levels of YAML that are not in brackets: each needs a column, a dash or a colon of its line.
class LineLevels {
 public:
  void take(char c, char next) {
    if (c == '\n' || c == '\r') {
      *this = {};
      return;
    }
    in_front_ = in_front_ && c == ' ';
    if (in_front_ || c == ':' || (c == '-' && next == ' ')) ++count_;
  }
  std::size_t count() const { return count_; }

 private:
  bool in_front_ = true;
  std::size_t count_ = 0;
};

}  // namespace

bool may_nest_too_deeply(std::string_view text) {
  OpenLevels open;
  LineLevels line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    open.take(text[i], next);
    line.take(text[i], next);
    if (open.count() > kMostLevels || line.count() > kMostLevels) return true;
  }
  return false;
}

}  // namespace amalgam::tracking
