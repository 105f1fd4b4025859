#include "bench/povray/pov_run.h"

#include <cstdlib>
#include <regex>
#include <stdexcept>

#include "bench/shell.h"

namespace amalgam::bench {
namespace {

std::string first_match(const std::string& text, const char* pattern) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : "";
}

}  // namespace

bool has_povray() {
  return !output_of("command -v povray").empty();
}

std::string povray_version() {
  return first_match(output_of("povray --version 2>&1"), "POV-Ray ([0-9.]*[0-9])");
}

double povray_trace_milliseconds(const std::filesystem::path& scene,
                                 const std::filesystem::path& picture, int width, int height,
                                 int threads) {
  const std::string text =
      output_of("povray -D -A -P +I" + quoted(scene) + " +O" + quoted(picture) + " +W" +
                std::to_string(width) + " +H" + std::to_string(height) + " +WT" +
                std::to_string(threads) + " 2>&1");
  const std::string seconds = first_match(text, "Trace Time:[^(]*\\(([0-9.]+) seconds\\)");
  if (seconds.empty()) {
    throw std::runtime_error("POV-Ray failed: " +
                             text.substr(text.size() > 300 ? text.size() - 300 : 0));
  }
  return 1000.0 * std::strtod(seconds.c_str(), nullptr);
}

}  // namespace amalgam::bench
