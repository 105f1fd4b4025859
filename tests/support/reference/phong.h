// What a diffuse surface sends back of the light that arrives (eq. 4.6), normalised.
#pragma once

#include "support/reference/vectors.h"

namespace amalgam::reference {

struct Phong {
  Color albedo{0.0};
  Color specular{0.0};
  double exponent = 0.0;
};

// From glTF's three numbers at a point.
Phong phong_of(const Color& base_color, double metallic, double roughness);

// A surface without a mirror image: scatters all of its base color.
Phong lambertian(const Color& base_color);

// Radiance towards to_viewer for irradiance 1 on a surface facing the light:
//   (N.L) (albedo / pi + specular (n + 2) / (2 pi) max(R.V, 0)^n)
// for N.L > 0. All vectors are unit and point away from the surface.
Color reflected(const Phong& phong, const Vec3& normal, const Vec3& to_light,
                const Vec3& to_viewer);

}  // namespace amalgam::reference
