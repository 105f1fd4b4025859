// What virtual objects do to the camera's color of a real diffuse surface, m and r its modelled
// light with and without them: by ratio L m / r, or by difference L + m - r (eq. 4.5). By ratio,
// what is nearly unlit (e r below 2^-8, wholly below 2^-10) still goes by difference.
#pragma once

#include "support/reference/color_curves.h"

namespace amalgam::reference {

struct RealChange {
  Color relative{0.0};    // q - 1
  Color difference{0.0};  // display-linear
};

RealChange real_change(const Color& m, const Color& r, const Response& response, bool by_ratio);

// Of the camera's scene-linear L.
Color changed_radiance(const Color& l, const Color& m, const Color& r, const Response& response,
                       bool by_ratio);

}  // namespace amalgam::reference
