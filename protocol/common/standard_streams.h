// Descriptors 0 to 2 of a program that was started without them.
#pragma once

namespace amalgam::common {

// Opens /dev/null for those of standard input, output and error that are closed. Otherwise the next
// socket or epoll would get such a number, and log lines would be written there.
void open_closed_standard_streams();

}  // namespace amalgam::common
