#include "common/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

namespace amalgam::common {

void open_closed_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // The lowest free number is this one, because those below it are open by now.
    if (::open("/dev/null", stream == STDIN_FILENO ? O_RDONLY : O_WRONLY) < 0) return;
  }
}

}  // namespace amalgam::common
