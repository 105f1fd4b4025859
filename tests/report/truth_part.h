// How near composites come to path-traced pictures of the real thing (tests/truth), and what each
// part of the method brings.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace amalgam::report {

// Mean differences to the truth over all scenes, environments and camera responses, in 1/255.
struct TruthRow {
  std::string method;
  double direct_objects = 0.0, direct_real = 0.0;  // without caustics and bounced light
  double full_objects = 0.0, full_real = 0.0;
};

// In quick the camera's image alone, the thesis's method, the default and 64 lights; otherwise also
// each part switched off alone. say: what is being done.
std::vector<TruthRow> measure_truth(bool quick, const std::function<void(const std::string&)>& say);

}  // namespace amalgam::report
