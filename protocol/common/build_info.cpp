#include "common/build_info.h"

namespace amalgam::common {

const char* version() {
  return AMALGAM_VERSION;
}

const char* instruction_set() {
#if !defined(__x86_64__)
  return "other";
#elif defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512VL__)
  return "x86-64-v4";
#elif defined(__AVX2__) && defined(__FMA__)
  return "x86-64-v3";
#elif defined(__SSE4_2__)
  return "x86-64-v2";
#else
  return "x86-64";
#endif
}

std::string version_line(const std::string& program) {
  return program + " " + version() + ", compiled for " + instruction_set();
}

}  // namespace amalgam::common
