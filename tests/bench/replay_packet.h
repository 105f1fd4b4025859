// The innermost part of the replay: a chunk of rays, asked of Embree one by one or by eight.
#pragma once

#include <embree3/rtcore.h>

#include <span>

#include "bench/replay.h"

namespace amalgam::bench {

void answer_one_by_one(RTCScene scene, std::span<const trace::LoggedRay> rays,
                       std::span<ReplayAnswer> answers);
void answer_by_eight(RTCScene scene, std::span<const trace::LoggedRay> rays,
                     std::span<ReplayAnswer> answers);

}  // namespace amalgam::bench
