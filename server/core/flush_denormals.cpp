#include "core/flush_denormals.h"

#include <pmmintrin.h>
#include <xmmintrin.h>

namespace amalgam::core {

FlushDenormals::FlushDenormals() : before_(_mm_getcsr()) {
  // Results that are denormal, and operands that are.
  _mm_setcsr(before_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
}

FlushDenormals::~FlushDenormals() {
  _mm_setcsr(before_);
}

}  // namespace amalgam::core
