#include "support/reference/real_change.h"

#include <algorithm>

namespace amalgam::reference {
namespace {

double weight_of_ratio(double exposed_real, bool by_ratio) {
  if (!by_ratio) return 0.0;
  const double low = 1.0 / 1024.0, high = 1.0 / 256.0;
  return std::clamp((exposed_real - low) / (high - low), 0.0, 1.0);
}

}  // namespace

RealChange real_change(const Color& m, const Color& r, const Response& response, bool by_ratio) {
  RealChange change;
  const Color step = tone_map(m, response) - tone_map(r, response);
  for (glm::length_t c = 0; c < 3; ++c) {
    const double w = weight_of_ratio(response.exposure * r[c], by_ratio);
    if (w > 0.0) change.relative[c] = w * (m[c] - r[c]) / r[c];
    change.difference[c] = (1.0 - w) * step[c];
  }
  return change;
}

Color changed_radiance(const Color& l, const Color& m, const Color& r, const Response& response,
                       bool by_ratio) {
  if (m == r) return l;
  Color result(0.0);
  for (glm::length_t c = 0; c < 3; ++c) {
    const double w = weight_of_ratio(response.exposure * r[c], by_ratio);
    const double by_difference = std::max(l[c] + m[c] - r[c], 0.0);
    result[c] = (1.0 - w) * by_difference + (w > 0.0 ? w * l[c] * m[c] / r[c] : 0.0);
  }
  return result;
}

}  // namespace amalgam::reference
