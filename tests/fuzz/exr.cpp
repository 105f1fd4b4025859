// An environment map of OpenEXR.
#include "fuzz/check_environment.h"
#include "fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const amalgam::fuzz::ScratchFile file("map.exr");
  amalgam::fuzz::check_environment(file, amalgam::fuzz::as_text(data, size));
  return 0;
}
