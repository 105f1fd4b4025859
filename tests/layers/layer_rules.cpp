#include "layers/layer_rules.h"

#include <array>
#include <functional>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace amalgam::layers {
namespace {

// Made by the build, in the folder's name.
constexpr std::array kGenerated{"protocol/amalgam.pb.h", "protocol/session_record.pb.h"};

// Under which folders a header is looked for by the name that it is included by.
constexpr std::array kRoots{"", "server/", "protocol/"};

std::string folder_of(const std::string& path) {
  return path.substr(0, path.rfind('/'));
}

std::string find_header(const std::set<std::string>& paths, const std::string& name) {
  for (const char* generated : kGenerated) {
    if (name == generated) return name;
  }
  for (const char* root : kRoots) {
    if (paths.contains(root + name)) return root + name;
  }
  return {};
}

}  // namespace

Rules parse_rules(std::string_view text) {
  Rules rules;
  std::set<std::string>* allowed = nullptr;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = line.substr(0, line.find('#'));
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos) {
      const auto [entry, is_new] = rules.try_emplace(line.substr(0, colon));
      if (!is_new) {
        throw std::invalid_argument("line " + std::to_string(number) + ": a second rule for " +
                                    entry->first);
      }
      allowed = &entry->second;
      line = line.substr(colon + 1);
    }
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (allowed == nullptr) {
        throw std::invalid_argument("line " + std::to_string(number) + ": no room before " + word);
      }
      allowed->insert(word);
    }
  }
  return rules;
}

std::vector<std::string> find_circles(const Rules& rules) {
  std::vector<std::string> circles;
  std::set<std::string> finished;
  std::vector<std::string> way;
  const std::function<void(const std::string&)> visit = [&](const std::string& room) {
    for (std::size_t i = 0; i < way.size(); ++i) {
      if (way[i] != room) continue;
      std::string circle;
      for (std::size_t k = i; k < way.size(); ++k) circle += way[k] + " -> ";
      circles.push_back(circle + room);
      return;
    }
    if (finished.contains(room)) return;
    way.push_back(room);
    if (const auto rule = rules.find(room); rule != rules.end()) {
      for (const std::string& other : rule->second)
        visit(other.ends_with(".h") ? folder_of(other) : other);
    }
    way.pop_back();
    finished.insert(room);
  };
  for (const auto& [room, allowed] : rules) visit(room);
  return circles;
}

std::vector<std::string> find_violations(const Rules& rules, const std::vector<SourceFile>& files) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*"([^"]+)")re");
  std::set<std::string> paths;
  for (const SourceFile& file : files) paths.insert(file.path);

  std::vector<std::string> violations;
  for (const SourceFile& file : files) {
    const std::string room = folder_of(file.path);
    const auto rule = rules.find(room);
    if (rule == rules.end()) continue;
    std::istringstream lines(file.text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
      std::smatch match;
      if (!std::regex_search(line, match, kInclude)) continue;
      const std::string at = file.path + ":" + std::to_string(number) + ": ";
      const std::string header = find_header(paths, match[1]);
      if (header.empty()) {
        violations.push_back(at + "there is no " + match[1].str());
        continue;
      }
      const std::string other = folder_of(header);
      if (other == room || rule->second.contains(other) || rule->second.contains(header)) continue;
      violations.push_back(at + room + " may not include " + other + " (" + header + ")");
    }
  }
  return violations;
}

}  // namespace amalgam::layers
