#include "bench/page_faults.h"

#include <sys/resource.h>

namespace amalgam::bench {

long minor_page_faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

}  // namespace amalgam::bench
