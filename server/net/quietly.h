// For the last line of defence: what is done after something was thrown must not throw itself.
#pragma once

namespace amalgam::net {

// Does it, or as much of it as works.
template <typename Step>
void quietly(Step step) noexcept {
  try {
    step();
  } catch (...) {
  }
}

}  // namespace amalgam::net
