// Measures one scene: renders a setting through moved cameras and compares it with the reference.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "bench/bench_case.h"
#include "bench/render_rig.h"
#include "report/picture_figures.h"
#include "report/reference_store.h"
#include "report/report_scene.h"
#include "report/run_row.h"
#include "report/sweep_point.h"

namespace amalgam::report {

// Each run looks through one of a few places of the camera, an equal number of runs through each.
// Places have references of their own: when the camera moves, so does its picture, and with it what
// is looked up there.
struct RunPlan {
  int runs = 20;
  int places = 5;
};

class SceneMeter {
 public:
  SceneMeter(const ReportScene& scene, bench::BenchCase bench_case, ReferenceStore& references,
             double exposure, const RunPlan& plan);

  // A run's row before anything is measured: where it is, what it is of, and which run.
  RunRow describe(const SweepPoint& point, int run) const;

  // One run. Before the first one of each place a frame is rendered for the error: the renderer is
  // deterministic, so it is that of all runs there. It also makes what is made only once.
  RunRow measure(const SweepPoint& point, int run);

  struct Pictures {
    common::ImageRgb32f ours, reference;
  };
  // At place 0.
  Pictures pictures(const SweepPoint& point);

 private:
  struct Errors {
    PictureFigures figures;
    double limit_mae = RunRow::kNone, floor_mae = RunRow::kNone, jpeg_mae = 0.0;
  };

  // A renderer, and what it is set to.
  struct Rig {
    std::string settings, view;
    std::unique_ptr<bench::RenderRig> renderer;
  };

  const bench::BenchCase& place(int index);
  // The renderer of the point, looking through the place.
  bench::RenderRig& renderer(const SweepPoint& point, int index);
  // To the knob's limit, at place 0 and with every pixel traced: the errors of shadow maps would
  // hide the knob's.
  double limit_error(const SweepPoint& point);
  const Errors& errors(const SweepPoint& point, int index);

  std::string scene_name_;
  decltype(ReportScene::move) move_;
  bench::BenchCase case_;
  ReferenceStore& references_;
  double exposure_;
  RunPlan plan_;
  std::map<int, bench::BenchCase> places_;

  // Making a renderer takes longer than most runs. Each sweep has the default among its points, so
  // its renderer stays; of the others, the last one.
  Rig default_, other_;

  std::string point_;             // in hand
  std::map<int, Errors> errors_;  // its, by place
};

}  // namespace amalgam::report
