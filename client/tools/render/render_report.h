// amalgam-render's report on its frames: JSON for programs, a pass list for people.
#pragma once

#include <ostream>
#include <vector>

#include "common/pose.h"
#include "frame/frame.h"

namespace amalgam::tools {

// One JSON object: stages_ms (per stage, min and median over the frames), rays, passes, pixels,
// provenance (pixels' shares by source of light), nonfinite, truncation_bound (mean, worst),
// exposure (green), white_balance (the channels' exposures over green's), tone_map (the curve),
// unchanged, poses, and quality (of the last frame) if there is a target frame rate.
void print_json(std::ostream& out, const std::vector<frame::FrameOutput>& frames,
                const std::vector<common::MarkerPose>& poses);

// Each pass with its time, or why it was left out.
void print_passes(std::ostream& out, const frame::FrameOutput& frame);

}  // namespace amalgam::tools
