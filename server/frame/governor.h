// Chooses the quality of a view's next frame from what its last ones took, so that a frame takes at
// most a given time.
//
// Down at once when a frame was over its budget; up only when a better choice has been predicted to
// take less than kCalm of the budget for several frames in a row. Costs are predicted from the
// measured ones by ratios between levels, which every change corrects (costs.h): what
// turned out to be wrong once is not tried again.
//
// Knows nothing of rendering and of clocks: the same costs give the same choices.
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
  static constexpr double kFits = 0.9;    // of the budget: what a lower choice is to take at most
  static constexpr int kCalmFrames = 5;   // before going up
  static constexpr int kLearnFrames = 5;  // after a change

  // jpeg: of one level if the quality is the client's.
  Governor(double budget_ms, std::vector<QualityLevel> ladder, std::vector<JpegLevel> jpeg);

  // What the next frame is to be rendered with.
  const QualityLevel& quality() const { return ladder_[choice().level]; }
  int jpeg_quality() const { return jpeg_[choice().jpeg].quality; }
  // For a frame's statistics.
  FrameQuality report() const;

  // What a frame that was rendered with the choice took. Frames that showed nothing virtual say
  // nothing about what showing it takes: they are to be left out.
  void frame_done(const FrameCost& cost);

 private:
  struct Choice {
    std::size_t level = 0, jpeg = 0;
    double harm() const;
  };
  // A stay at one choice: costs for each thing traced, smoothed.
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
  double last_other_ = 0.0;  // as measured, before it is believed
  Stay stay_;
  std::optional<Stay> before_;
  int calm_ = 0;  // frames in a row for which a better choice would have fitted
};

}  // namespace amalgam::frame
