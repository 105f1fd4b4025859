// Page faults of this process, from the kernel's count.
#pragma once

namespace amalgam::bench {

// Faults so far that needed no disk: pages that were touched for the first time. All threads.
long minor_page_faults();

}  // namespace amalgam::bench
