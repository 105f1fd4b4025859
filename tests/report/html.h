// HTML from small functions. Text is escaped where it enters; what has type Html is markup already,
// so that neither can be taken for the other.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace amalgam::report {

struct Html {
  std::string markup;

  Html& operator+=(const Html& other) {
    markup += other.markup;
    return *this;
  }
  friend Html operator+(Html a, const Html& b) { return a += b; }
};

// Escapes & < > " '.
Html text(std::string_view plain);

// <name>content</name>.
Html element(const std::string& name, const Html& content);
Html element(const std::string& name, std::string_view plain);
// With class="...".
Html element(const std::string& name, const std::string& css_class, const Html& content);

// A table with a head; rows must be as long. Cells that are numbers should be aligned: columns from
// first_number on are.
Html table(const std::vector<std::string>& head, const std::vector<std::vector<Html>>& rows,
           std::size_t first_number);

// A picture within the page, of its file's bytes.
Html png_image(const std::string& png, std::string_view description);

// "1.23e-04" and the like: three digits.
Html number(double value);

}  // namespace amalgam::report
