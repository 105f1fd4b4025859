// What the Protocol Buffers library has to say goes through our log, as all else does.
#pragma once

namespace amalgam::protocol {

// Otherwise the library writes to standard error itself: unasked, unbounded, and waiting.
void take_over_protobuf_log();

}  // namespace amalgam::protocol
