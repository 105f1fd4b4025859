#include "bench/goal_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <ostream>

namespace amalgam::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

std::string note_of(const GoalLine& line) {
  if (const auto* missing = std::get_if<NotMeasured>(&line.outcome)) return missing->reason;
  const auto& measured = std::get<Measurement>(line.outcome);
  std::string note = number(measured.low) + " to " + number(measured.high) + "; " + measured.note;
  if (measured.broken_condition) note += "; " + *measured.broken_condition;
  return note;
}

Json to_json(const GoalLine& line) {
  Json json{{"name", line.goal.name}, {"what", line.goal.what}, {"ratio", nullptr},
            {"low", nullptr},         {"high", nullptr},        {"unit", line.goal.unit}};
  json["comparison"] = to_string(line.goal.comparison);
  json["goal"] = line.goal.bound;
  json["verdict"] = to_string(verdict(line));
  if (const auto* measured = std::get_if<Measurement>(&line.outcome)) {
    json["ratio"] = measured->value;
    json["low"] = measured->low;
    json["high"] = measured->high;
    json["note"] = measured->note;
    if (measured->broken_condition) json["broken_condition"] = *measured->broken_condition;
  } else {
    json["note"] = std::get<NotMeasured>(line.outcome).reason;
  }
  return json;
}

Json to_json(const ThesisResult& result) {
  const ThesisRow& row = result.row;
  return {{"scene", to_string(row.scene)},
          {"samples", row.samples},
          {"width", row.width},
          {"height", row.height},
          {"pc", row.pc},
          {"method", to_string(row.method)},
          {"image", row.image},
          {"thesis_fps", row.frames_per_second},
          {"our_fps", result.frames_per_second},
          {"ratio", result.ratio()},
          {"our_still_fps",
           result.still_frames_per_second ? Json(*result.still_frames_per_second) : Json(nullptr)},
          {"error", result.error},
          {"adaptive", result.adaptive},
          {"adaptive_error", result.adaptive_error ? Json(*result.adaptive_error) : Json(nullptr)},
          {"held_to_goal", is_held_to_goal(row)}};
}

void print_row(std::ostream& out, const ThesisResult& result) {
  const ThesisRow& row = result.row;
  const std::string size = std::to_string(row.width) + "x" + std::to_string(row.height);
  const std::string samples = row.samples == 1 ? "" : std::to_string(row.samples) + "x";
  std::string note = result.adaptive ? "adaptive" : "";
  if (result.adaptive_error && !result.adaptive) {
    note = *result.adaptive_error > result.error ? "fixed: adaptive is further off"
                                                 : "fixed: adaptive is slower";
  }
  if (!is_held_to_goal(row)) {
    note = row.pc == 1 ? "no such method here: hybrid" : "the thesis's other PC";
  }
  char still[32] = "-";
  if (result.still_frames_per_second)
    std::snprintf(still, sizeof still, "%.1f", *result.still_frames_per_second);
  char text[256];
  std::snprintf(text, sizeof text, "%-13s %-3s %-10s %-22s %9.1f %8.2f %7.2f %7s %7.2f  %s",
                to_string(row.scene), samples.c_str(), size.c_str(), to_string(row.method),
                row.frames_per_second, result.frames_per_second, result.ratio(), still,
                result.error, note.c_str());
  out << text << '\n';
}

}  // namespace

void print_head(std::ostream& out, int cores) {
  out << "goals, on " << cores << " cores: name, ratio, goal, verdict, how (spread)\n";
}

void print_line(std::ostream& out, const GoalLine& line) {
  const auto* measured = std::get_if<Measurement>(&line.outcome);
  const std::string value = measured != nullptr ? number(measured->value) : "-";
  const std::string bound = with_unit(
      std::string(to_string(line.goal.comparison)) + " " + number(line.goal.bound), line.goal.unit);
  char text[128];
  std::snprintf(text, sizeof text, "%-16s %8s  %-11s %-12s  ", line.goal.name.c_str(),
                value.c_str(), bound.c_str(), to_string(verdict(line)));
  out << text << line.goal.what << " (" << note_of(line) << ")\n";
}

void print_thesis(std::ostream& out, const std::vector<ThesisResult>& results) {
  if (results.empty()) return;
  out << "\nthesis Table 6.1: scene, samples, size, renderer, thesis fps, ours, ratio, ours while "
         "nothing moves, mean error in 1/255\n";
  for (const ThesisResult& result : results) print_row(out, result);
}

void print_json(std::ostream& out, const GoalReport& report) {
  Json json{{"cores", report.cores}, {"goals", Json::array()}, {"table_6_1", Json::array()}};
  for (const GoalLine& line : report.lines) json["goals"].push_back(to_json(line));
  for (const ThesisResult& result : report.thesis) json["table_6_1"].push_back(to_json(result));
  out << json.dump(2) << '\n';
}

}  // namespace amalgam::bench
