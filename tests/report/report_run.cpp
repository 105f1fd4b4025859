#include "report/report_run.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "bench/goals/thesis_meter.h"
#include "report/composites.h"
#include "report/gnuplot.h"
#include "report/progress_line.h"
#include "report/report_page.h"
#include "report/report_scene.h"
#include "report/runs_file.h"
#include "report/sweeps.h"
#include "report/whole_file.h"

namespace amalgam::report {
namespace {

namespace fs = std::filesystem;

bool is_wanted(const std::string& name, const std::vector<std::string>& only) {
  return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
}

// A scene that is there.
struct LoadedScene {
  ReportScene scene;
  bench::BenchCase bench_case;
  float exposure = 1.0f;
  std::vector<SweepPoint> points;
};

class Report {
 public:
  explicit Report(const ReportOptions& options)
      : options_(options),
        output_(made_folder(options.output)),
        runs_(output_ / "runs.csv"),
        references_(options.references, [this](const std::string& what) { say(what); }) {
    check_gnuplot();
  }

  void make() {
    load_scenes();
    int steps = 0;
    for (const LoadedScene& scene : scenes_) {
      steps += static_cast<int>(scene.points.size()) * options_.plan.runs + kOtherSteps;
    }
    progress_.emplace(steps);
    for (const std::string& note : data_.notes) progress_->note("amalgam-report: " + note);
    for (const LoadedScene& scene : scenes_) measure(scene);
    if (options_.wants(kTablePart)) measure_table();
    if (options_.wants(kTruthPart) && options_.only.empty()) {
      data_.truth = measure_truth(options_.quick, [this](const std::string& what) { say(what); });
    }
    write();
    progress_->note(output_.string() + ": runs.csv, summary.csv, report.html");
  }

 private:
  // Of each scene, for the estimate of the time: jitter and determinism.
  static constexpr int kOtherSteps = 10;

  static fs::path made_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw std::runtime_error(folder.string() + ": " + error.message());
    return folder;
  }

  void say(const std::string& what) {
    if (progress_) progress_->say(what);
  }

  void load_scenes() {
    for (ReportScene& scene :
         report_scenes(options_.scenes, options_.quick && options_.only.empty())) {
      if (!is_wanted(scene.name, options_.only)) continue;
      try {
        LoadedScene loaded;
        loaded.scene = scene;
        loaded.bench_case = scene.load(options_.size.x, options_.size.y);
        loaded.exposure = metered_exposure(loaded.bench_case);
        if (options_.wants(kSweepPart)) loaded.points = wanted_points(scene, loaded.exposure);
        scenes_.push_back(std::move(loaded));
      } catch (const bench::MissingScene& missing) {
        data_.notes.push_back(scene.name + " is skipped: " + missing.what());
      }
    }
    if (scenes_.empty()) throw std::runtime_error("no scene is there: " + data_.notes.front());
  }

  std::vector<SweepPoint> wanted_points(const ReportScene& scene, float exposure) const {
    auto points = make_sweeps({.quick = options_.quick,
                               .threads = options_.threads,
                               .exposure = exposure,
                               .stiff = scene.is_stiff,
                               .bounce_reflectance = scene.bounce_reflectance});
    std::erase_if(
        points, [&](const SweepPoint& point) { return !is_wanted(point.sweep, options_.sweeps); });
    return points;
  }

  void measure(const LoadedScene& loaded) {
    const std::string& name = loaded.scene.name;
    const double exposure = static_cast<double>(loaded.exposure);
    SceneMeter meter(loaded.scene, loaded.bench_case, references_, exposure, options_.plan);
    for (const SweepPoint& point : loaded.points) measure(name, meter, point);
    if (options_.wants(kJitterPart) && !loaded.scene.is_stiff) {
      say(name + ": camera jitter");
      const auto spec = best_reference(options_.quick ? quick_quality() : full_quality());
      data_.jitter.push_back(measure_jitter(name, loaded.bench_case, references_, exposure, spec,
                                            options_.quick ? 5 : 50));
    }
    // In quick for one scene of rasterised and traced surfaces, and for one of many triangles.
    const bool is_chosen = !options_.quick || name == "complex" || name == "glass bunny";
    if (options_.wants(kDeterminismPart) && is_chosen) {
      say(name + ": determinism");
      const auto hashes = measure_determinism(name, loaded.bench_case);
      data_.hashes.insert(data_.hashes.end(), hashes.begin(), hashes.end());
    }
    for (int i = 0; i < kOtherSteps; ++i) progress_->step_done();
    find_worst(loaded, meter);
  }

  void measure(const std::string& scene, SceneMeter& meter, const SweepPoint& point) {
    for (int run = 0; run < options_.plan.runs; ++run) {
      const RunRow wanted = meter.describe(point, run);
      runs_.check_like(wanted);
      if (runs_.has(run_key(wanted))) {
        progress_->step_skipped();
        continue;
      }
      say(scene + ": " + point.sweep + " " + point.label);
      runs_.append(meter.measure(point, run));
      progress_->step_done();
    }
  }

  // The setting that is further off than all others.
  void find_worst(const LoadedScene& loaded, SceneMeter& meter) {
    const PointSummary* worst = nullptr;
    const std::vector<PointSummary> points = summarise(runs_.rows());
    for (const PointSummary& point : points) {
      if (point.scene != loaded.scene.name) continue;
      if (worst == nullptr || point.mae > worst->mae) worst = &point;
    }
    if (worst == nullptr) return;
    for (const SweepPoint& point : loaded.points) {
      if (point.sweep != worst->sweep || point.label != worst->point) continue;
      SceneMeter::Pictures pictures = meter.pictures(point);
      data_.worst.push_back({worst->scene, full_name(*worst), worst->mae, std::move(pictures.ours),
                             std::move(pictures.reference)});
    }
  }

  // In quick a row of each method that we have too, of the scene that renders fastest.
  bool is_in_table(const bench::ThesisRow& row) const {
    if (!is_wanted(bench::to_string(row.scene), options_.only)) return false;
    if (!options_.quick) return true;
    return row.scene == bench::ThesisScene::Complex && row.height == 600 &&
           bench::is_held_to_goal(row);
  }

  void measure_table() {
    const bench::BenchScenes scenes(options_.scenes);
    bench::ThesisMeter meter(scenes, options_.quick ? 0.5 : 3.0);
    for (const bench::ThesisRow& row : bench::thesis_table()) {
      if (!is_in_table(row)) continue;
      say(std::string("Table 6.1, ") + bench::to_string(row.scene));
      try {
        data_.table.push_back(meter.measure(row));
      } catch (const bench::MissingScene&) {
        // Said where the scene was skipped.
      }
    }
  }

  void write() {
    data_.points = summarise(runs_.rows());
    std::map<std::string, double> reflectances;
    for (const LoadedScene& scene : scenes_) {
      if (scene.scene.bounce_reflectance) {
        reflectances[scene.scene.name] = *scene.scene.bounce_reflectance;
      }
    }
    data_.laws = find_laws(data_.points, reflectances);
    set_slopes(data_.points, data_.laws);
    data_.bounds = check_bounds(runs_.rows());
    if (!runs_.rows().empty()) data_.host = runs_.rows().front();
    say("writing");
    write_whole_file(output_ / "summary.csv", summary_csv(data_.points));
    write_whole_file(output_ / "report.html", report_page(data_));
  }

  const ReportOptions& options_;
  fs::path output_;
  RunsFile runs_;
  ReferenceStore references_;
  std::optional<ProgressLine> progress_;
  std::vector<LoadedScene> scenes_;
  ReportData data_;
};

}  // namespace

void make_report(const ReportOptions& options) {
  Report(options).make();
}

}  // namespace amalgam::report
