// TBB starts no more workers than there are cores, whatever an arena asks for. While this lives it
// does, so that tests with sixteen threads have them on any machine.
#pragma once

#include <tbb/global_control.h>

namespace amalgam::test_support {

class ManyWorkers {
 private:
  tbb::global_control allowed_{tbb::global_control::max_allowed_parallelism, 64};
};

}  // namespace amalgam::test_support
