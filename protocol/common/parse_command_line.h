// Reading a program's command line with CLI11, the same way in each program.
//
// Only for files that include CLI11 anyway: this header is the one of the room that does.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace amalgam::common {

// parse calls one of app's parse functions. False if the program is to end, because it was asked
// for its help or version, which then is on standard output. Throws std::invalid_argument with one
// line for whatever is wrong.
inline bool parse_command_line(CLI::App& app, const std::function<void()>& parse) {
  try {
    parse();
    return true;
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
  } catch (const CLI::CallForVersion& version) {
    std::cout << version.what() << '\n';
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what());
  }
  return false;
}

// A number from low to high. CLI::Range lets NaN pass.
template <typename Number>
CLI::Validator in_range(Number low, Number high) {
  std::ostringstream range;
  range << '[' << low << " - " << high << ']';
  return CLI::Validator(
      [low, high, range = range.str()](const std::string& text) -> std::string {
        Number value{};
        const bool good = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
        return good ? std::string() : "Value " + text + " not in range " + range;
      },
      std::string(std::is_floating_point_v<Number> ? "FLOAT" : "INT") + " in " + range.str());
}

inline bool parse_command_line(CLI::App& app, int argc, const char* const* argv) {
  return parse_command_line(app, [&] { app.parse(argc, argv); });
}

}  // namespace amalgam::common
