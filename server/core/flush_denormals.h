// Denormal floats (below 1.2e-38) count as zero while this lives, on the thread that made it.
//
// An operation on a denormal number takes a processor a hundred times as long as another, and no
// color of a picture is so dark (numerics B24). Needed by the thread that renders; the workers of a
// tbb::task_arena take over the mode of the thread that first runs something in it.
#pragma once

namespace amalgam::core {

class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();  // as it was before
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned before_;
};

}  // namespace amalgam::core
