// Whether a text could nest so deeply that a parser which calls itself for each level runs out of
// stack.
#pragma once

#include <string_view>

namespace amalgam::tracking {

// For YAML, JSON and XML as OpenCV reads them. Errs on the safe side, because the parsers do not
// agree on where strings and comments end: what has a quote or a comment in it counts as if it were
// never closed. OpenCV's parsers take some 30000 levels on a stack of 8 MiB; up to twice 5000 pass.
bool may_nest_too_deeply(std::string_view text);

}  // namespace amalgam::tracking
