// The rules that say which folder may include which, and what breaks them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace amalgam::layers {

// By room, a folder relative to the project: rooms, and single headers, that it may include.
using Rules = std::map<std::string, std::set<std::string>>;

// Throws std::invalid_argument, naming the line.
Rules parse_rules(std::string_view text);

// Rooms that reach themselves through what they may include; each as "a -> b -> a".
std::vector<std::string> find_circles(const Rules& rules);

struct SourceFile {
  std::string path;  // relative to the project, such as "server/trace/tile.cpp"
  std::string text;
};

// Lines that include what their room may not, or what is not there, as "path:line: why". Only
// includes in quotation marks count; generated headers are known by name. files: all of the
// project, those of rooms without a rule are not checked.
std::vector<std::string> find_violations(const Rules& rules, const std::vector<SourceFile>& files);

}  // namespace amalgam::layers
