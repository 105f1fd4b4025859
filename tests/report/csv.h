// Comma-separated values after RFC 4180, with line feeds alone: quotes where a field needs them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace amalgam::report {

using CsvRow = std::vector<std::string>;

// With its line feed.
std::string csv_line(const CsvRow& fields);

struct CsvText {
  std::vector<CsvRow> rows;
  // Bytes up to the end of the last whole row: what follows is a row that was cut off.
  std::size_t whole_size = 0;
};

// A row is whole if it ends with a line feed outside quotes.
CsvText parse_csv(std::string_view text);

// The shortest text that parses to the same number: "nan" and "inf" included.
std::string csv_number(double value);
// NaN where the text is no number, as an empty one.
double parse_csv_number(const std::string& text);

}  // namespace amalgam::report
