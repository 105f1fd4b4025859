// Chooses the quality of a view's next frame from the times of its last ones, so that a frame takes
// at most a given time (the budget).
//
// Quality goes down at once when a frame exceeds its budget. It goes up when a better choice is
// predicted to take less than kCalm of the budget for several frames in a row. Predictions multiply
// measured times by cost ratios between levels. Every change of level corrects these ratios
// (costs.h), so a wrong prediction is not repeated.
//
// Independent of rendering and of clocks: the same costs give the same choices.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "frame/costs.h"
#include "frame/quality_ladder.h"

namespace amalgam::frame {

class Governor {
 public:
  static constexpr double kCalm = 0.8;    // of the budget
  static constexpr double kFits = 0.9;    // of the budget: the most that a lower choice may take
  static constexpr int kCalmFrames = 5;   // in a row, before going up
  static constexpr int kLearnFrames = 5;  // after a change, which correct the ratios

  // jpeg: a single level if the client sets the quality.
  Governor(double budget_ms, std::vector<QualityLevel> ladder, std::vector<JpegLevel> jpeg);

  // The quality for the next frame.
  const QualityLevel& quality() const { return ladder_[choice().level]; }
  int jpeg_quality() const { return jpeg_[choice().jpeg].quality; }
  // For a frame's statistics.
  FrameQuality report() const;

  // Reports the time of a frame rendered with the choice. Not for frames that showed nothing
  // virtual: their times say nothing about the others.
  void frame_done(const FrameCost& cost);

 private:
  struct Choice {
    std::size_t level = 0, jpeg = 0;
    double harm() const;
  };
  // A period at one choice. smooth: costs as of a picture full of specular pixels, smoothed.
  struct Stay {
    std::size_t choice = 0;  // index
    int frames = 0;
    FrameCost smooth;
  };

  const Choice& choice() const { return choices_[current_]; }
  FrameCost predict(std::size_t choice) const;
  bool is_sensible(std::size_t choice) const;
  bool fits(std::size_t choice, double share) const;
  std::size_t next_lower(std::size_t choice) const;
  void learn(const FrameCost& cost);
  void go_down();
  void consider_going_up();
  void change_to(std::size_t choice);

  double budget_;  // ms
  std::vector<QualityLevel> ladder_;
  std::vector<JpegLevel> jpeg_;
  std::vector<Choice> choices_;  // by harm, the best first
  std::size_t current_ = 0;
  RelativeCosts trace_, raster_, encode_;
  FrameCost last_;           // measured, with the current choice
  double last_other_ = 0.0;  // the last frame's, as measured
  Stay stay_;
  std::optional<Stay> before_;
  int calm_ = 0;  // frames in a row for which a better choice would have fitted
};

}  // namespace amalgam::frame
