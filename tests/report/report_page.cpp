#include "report/report_page.h"

#include <algorithm>
#include <set>

#include "report/charts.h"
#include "report/gnuplot.h"
#include "report/page_sections.h"
#include "report/page_style.h"

namespace amalgam::report {
namespace {

class Charts {
 public:
  void add(const Chart& chart) {
    std::string prefix("chart");
    prefix += std::to_string(count_++) + "-";
    const Html svg{draw(chart, prefix)};
    if (!svg.markup.empty()) all_ += element("figure", svg);
  }
  Html section(const std::string& title, const std::string& words) {
    if (all_.markup.empty()) return {};
    return element("h2", title) + element("p", words) +
           element("div", "charts", std::exchange(all_, Html{}));
  }

 private:
  int count_ = 0;
  Html all_;
};

Html host_lines(const ReportData& data) {
  const RunRow& host = data.host;
  std::string line = "Commit " + host.commit + ", " + host.host_cpu + ", compiled for " + host.isa +
                     ", " + std::to_string(host.threads) + " threads, pictures of " +
                     std::to_string(host.width) + "x" + std::to_string(host.height) + " pixels.";
  return host.commit.empty() ? Html{} : element("p", "faint", text(line));
}

Html method() {
  return element(
      "p",
      "How to read it: each point is one setting of the renderer. Its time is the least of all "
      "runs, from the camera's JPEG to the composite's; the bar ends at the median. Its error is "
      "that of the composite before JPEG to an independent renderer in double precision, in "
      "display-linear light; bars are 95 % intervals (bootstrap). The renderer is deterministic, "
      "so runs look through a camera whose principal point is moved by up to half a pixel, to a "
      "few places. Each place has a reference of its own, because the camera's picture, which "
      "mirrors and glass show, moves too.");
}

Html reference_words(const std::vector<PointSummary>& points) {
  Html list;
  for (const std::string& reference : names_of(points, &PointSummary::reference)) {
    std::string sweeps;
    std::vector<std::string> named;
    for (const PointSummary& point : points) {
      if (point.reference != reference) continue;
      if (std::find(named.begin(), named.end(), point.sweep) != named.end()) continue;
      named.push_back(point.sweep);
      sweeps += (sweeps.empty() ? "" : ", ") + point.sweep;
    }
    list += element("li", reference + " (" + sweeps + ")");
  }
  if (list.markup.empty()) return {};
  return element("p", "References, and the sweeps that are compared with them:") +
         element("ul", list) +
         element("p",
                 "A cut-off of 0 would cost 2^depth rays in glass. Errors of a cut-off grow in "
                 "proportion to it, so that of the reference is to a setting's as the cut-offs "
                 "are. Where the number of lights is swept, the reference has the samples of the "
                 "setting at the same places: what remains is the error of the lights. The JPEG's "
                 "subsampling cannot be chosen: the encoder takes 4:2:0 below quality 95 and 4:4:4 "
                 "from there on.");
}

Html notes(const std::vector<std::string>& lines) {
  Html list;
  for (const std::string& line : lines) list += element("li", line);
  return list.markup.empty() ? Html{} : element("h2", "Not measured") + element("ul", list);
}

Html charts(const ReportData& data) {
  Charts charts;
  for (const std::string& scene : names_of(data.points, &PointSummary::scene)) {
    charts.add(scene_chart(data.points, scene));
  }
  Html all = charts.section("Error against time",
                            "All settings of a scene. Nothing is both faster and better than a "
                            "setting on the Pareto line; those are named.");
  for (const std::string& sweep : names_of(data.points, &PointSummary::sweep)) {
    charts.add(sweep_chart(data.points, sweep));
  }
  all += charts.section("One knob at a time",
                        "Everything else is as by default; for the depth, the cut-off is 0.004, "
                        "and for the cut-off, the depth is 32.");
  std::vector<std::string> swept;
  for (const Law& law : data.laws) {
    if (std::find(swept.begin(), swept.end(), law.sweep) != swept.end()) continue;
    swept.push_back(law.sweep);
    charts.add(law_chart(data.points, data.laws, law.sweep));
  }
  all += laws_section(data.laws);
  return all + charts.section("Laws", "Points are measured, lines are fitted.");
}

}  // namespace

std::string report_page(const ReportData& data) {
  const char* title = "Amalgam: error against run time";
  const Html head{
      "<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"};
  Html body = element("h1", title) + host_lines(data) + notes(data.notes) + method();
  body += charts(data);
  body += bounds_section(data.bounds) + jitter_section(data.jitter) +
          determinism_section(data.hashes) + thesis_section(data.table) +
          truth_section(data.truth) + worst_section(data.worst) + points_section(data.points) +
          reference_words(data.points);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n" +
         element("head", head + element("title", title) + element("style", Html{kPageStyle}))
             .markup +
         element("body", body).markup + "</html>\n";
}

}  // namespace amalgam::report
