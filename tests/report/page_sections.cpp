#include "report/page_sections.h"

#include "report/picture_figures.h"
#include "report/worst_pictures.h"

namespace amalgam::report {
namespace {

Html verdict(bool good, const char* yes, const char* no) {
  return element("span", good ? "good" : "bad", text(good ? yes : no));
}

Html paragraph(std::string_view plain) {
  return element("p", plain);
}

}  // namespace

Html laws_section(const std::vector<Law>& laws) {
  if (laws.empty()) return {};
  std::vector<std::vector<Html>> rows;
  for (const Law& law : laws) {
    rows.push_back({text(law.sweep), text(law.scene), text(law.quantity), text(law.expected),
                    number(law.slope), verdict(law.pass, "pass", "fail")});
  }
  return element("h2", "Expected slopes") +
         paragraph(
             "The error here is the one to the same setting with the knob at its limit, with every "
             "pixel traced, so that other errors do not hide the law. Points below 1e-6 are left "
             "out: there the two renderers' arithmetic differs. A slope passes within 10 % of what "
             "is "
             "expected.") +
         table({"knob", "scene", "slope", "expected", "measured", "verdict"}, rows, 3);
}

Html jitter_section(const std::vector<JitterErrors>& jitter) {
  if (jitter.empty()) return {};
  std::vector<std::vector<Html>> rows;
  for (const JitterErrors& errors : jitter) {
    rows.push_back({text(errors.scene), number(errors.marker_pixels),
                    text(std::to_string(errors.draws)), number(errors.tracking),
                    number(errors.rendering), number(errors.jpeg), number(errors.together)});
  }
  return element("h2", "Camera jitter") +
         paragraph(
             "A tracker finds the marker's corners with noise: 0.5 pixels on each axis of a "
             "picture 640 pixels wide. The pose is solved from them. Mean absolute errors, white "
             "is 1: tracking "
             "is the composite with the noisy pose to the one with the true pose; rendering "
             "is the true pose's to the reference; JPEG is after to before encoding; "
             "together is the noisy pose's after JPEG to the reference. Parts need not add "
             "up: errors may cancel.") +
         table(
             {"scene", "marker's side [px]", "draws", "tracking", "rendering", "JPEG", "together"},
             rows, 1);
}

Html bounds_section(const std::vector<BoundCheck>& bounds) {
  if (bounds.empty()) return {};
  std::vector<std::vector<Html>> rows;
  for (const BoundCheck& check : bounds) {
    rows.push_back({text(check.scene), text(std::to_string(check.settings)),
                    text(std::to_string(check.held)), number(check.median_ratio),
                    verdict(check.held == check.settings, "holds", "broken")});
  }
  return element("h2", "Truncation bound") +
         paragraph(
             "Each frame states how far cutting rays off by depth and cut-off may have moved it. "
             "Here that is compared with how far it did, in the mean over the picture, for each "
             "depth and cut-off. A single lamp makes the bound wide, because any ray that was cut "
             "off might have met it; so do mirrors that shine themselves.") +
         table({"scene", "settings", "within the bound", "bound / error, median", "verdict"}, rows,
               1);
}

// A row a scene, with a column for each number of threads and instruction set.
Html determinism_section(const std::vector<LayersHash>& hashes) {
  if (hashes.empty()) return {};
  std::vector<std::string> head{"scene", "hash"};
  for (const LayersHash& row : hashes) {
    if (row.scene == hashes.front().scene) head.push_back(row.what);
  }
  std::vector<std::vector<Html>> rows;
  std::string scene, first;
  for (const LayersHash& row : hashes) {
    if (row.scene != scene) {
      scene = row.scene;
      first = row.hash;
      rows.push_back({text(scene), element("code", text(first.substr(0, 16)))});
    }
    const std::string difference = std::to_string(row.differing_pixels) + " pixels by up to ";
    rows.back().push_back(row.hash == first ? verdict(true, "equal", "")
                                            : text(difference) + number(row.largest_difference));
  }
  return element("h2", "Determinism") +
         paragraph(
             "SHA-256 of the float layers (first 16 digits), with each number of threads and each "
             "instruction set of Embree that the processor has. Instruction sets may differ in the "
             "last bits, which decide what a ray meets at an edge. Differences are display-linear, "
             "to the picture of one thread.") +
         table(head, rows, head.size());
}

Html thesis_section(const std::vector<bench::ThesisResult>& results) {
  if (results.empty()) return {};
  std::vector<std::vector<Html>> rows;
  for (const bench::ThesisResult& result : results) {
    const bench::ThesisRow& row = result.row;
    const std::string samples = row.samples == 1 ? "none" : std::to_string(row.samples) + "x";
    std::string note = result.adaptive ? "ours: adaptive samples" : "";
    if (row.pc != 1) note = "the thesis's other PC";
    if (row.pc == 1 && !bench::is_held_to_goal(row)) note = "ours: the hybrid renderer";
    rows.push_back({text(bench::to_string(row.scene)),
                    text(std::to_string(row.width) + "x" + std::to_string(row.height)),
                    text(samples), text(bench::to_string(row.method)), text(note),
                    number(result.frames_per_second), number(row.frames_per_second),
                    number(result.ratio()), number(result.error)});
  }
  return element("h2", "Table 6.1 of the thesis, anew") +
         paragraph(
             "Frames a second, ours on this machine and the thesis's on its own, and the "
             "mean absolute error of our picture to one with 16 samples a pixel, in 1/255 of "
             "the bytes, taken at a width of 320 pixels.") +
         table({"scene", "size", "anti-aliasing", "renderer", "", "ours [1/s]", "thesis [1/s]",
                "ratio", "our error [1/255]"},
               rows, 5);
}

Html truth_section(const std::vector<TruthRow>& rows) {
  if (rows.empty()) return {};
  std::vector<std::vector<Html>> cells;
  for (const TruthRow& row : rows) {
    cells.push_back({text(row.method), number(row.direct_objects), number(row.direct_real),
                     number(row.full_objects), number(row.full_real)});
  }
  return element("h2", "Against reality") +
         paragraph(
             "Composites onto path-traced pictures of real tables, against path-traced pictures of "
             "the same with the objects really there (Blender's Cycles): six scenes, three "
             "environments, two camera responses. Mean differences in 1/255, on the pixels of "
             "objects and on the real surfaces that they change. Direct: without caustics and "
             "without light from one diffuse surface to another, which Amalgam leaves out.") +
         table({"method", "direct: objects", "shadows", "full: objects", "shadows"}, cells, 1);
}

Html worst_section(const std::vector<WorstCase>& cases) {
  if (cases.empty()) return {};
  Html section = element("h2", "Worst cases") +
                 paragraph(
                     "Of each scene the setting with the largest mean error: ours, the "
                     "reference, and their difference times 10.");
  for (const WorstCase& worst : cases) {
    char error[32];
    std::snprintf(error, sizeof error, "%.3g", worst.mae);
    const std::string title = worst.scene + ", " + worst.point + ": error " + error;
    const auto figure = [](const common::ImageRgb8& picture, const char* name) {
      return element("figure", png_image(as_png(picture), name) + element("figcaption", name));
    };
    section +=
        element("h3", title) +
        element("div", "pictures",
                figure(as_bytes(worst.ours), "ours") +
                    figure(as_bytes(worst.reference), "reference") +
                    figure(difference_picture(worst.ours, worst.reference), "difference x 10"));
  }
  return section;
}

Html points_section(const std::vector<PointSummary>& points) {
  if (points.empty()) return {};
  std::vector<std::vector<Html>> rows;
  for (const PointSummary& p : points) {
    std::string marks = p.pareto ? "Pareto" : "";
    if (p.at_floor) marks += marks.empty() ? "at floor" : ", at floor";
    rows.push_back({text(p.scene), text(full_name(p)), text(marks), text(p.equal_time),
                    text(p.equal_error), number(p.time_min), number(p.time_median), number(p.mae),
                    number(p.mae_interval.low), number(p.mae_interval.high), number(p.ssim),
                    number(p.psnr), number(p.maximum), number(p.jpeg_mae), number(p.efficiency)});
  }
  return element("h2", "All settings") +
         paragraph(
             "At floor: below 3 times the reference's own error. Partners are settings of "
             "the same scene: the least error at no more time, and the least time at no more "
             "error. Efficiency is 1 / (MSE t). The files runs.csv and summary.csv have "
             "more columns.") +
         table({"scene", "setting", "", "equal-time partner", "equal-error partner",
                "least time [ms]", "median time [ms]", "error", "95 % from", "to", "SSIM",
                "PSNR [dB]", "maximum", "JPEG error", "efficiency [1/s]"},
               rows, 5);
}

}  // namespace amalgam::report
