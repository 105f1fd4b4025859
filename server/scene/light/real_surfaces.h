// What virtual objects change of the light on a real surface, as a change of the camera's color.
//
// m and r are the modelled radiance of the surface with and without the virtual objects. The camera
// knows the surface's true color, the model does not. So there are two ways:
//
//   Ratio        I_c becomes TM(TM^-1(I_c) m / r): right for any albedo, as m / r is the change of
//                the light alone
//   Difference   I_c becomes I_c + TM(m) - TM(r): the thesis's (eq. 4.5), right only if the model
//                has the surface's true color
//
// Where the model sees next to no light, m / r means nothing: ambient light that it does not know
// would make the true ratio another. There Ratio turns gradually into Difference, from an exposed
// radiance e r of 2^-8 down to 2^-10.
//
// m = r changes nothing, to the bit.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

#include "scene/light/tone_map.h"

namespace amalgam::scene {

enum class RealSurfaces : std::uint8_t { Ratio, Difference };

// Throws std::invalid_argument naming the choices.
RealSurfaces parse_real_surfaces(std::string_view text);
const char* real_surfaces_name(RealSurfaces real_surfaces);

// Of one sample.
struct LightChange {
  glm::vec3 relative{0.0f};    // q - 1, q the factor on the camera's radiance
  glm::vec3 difference{0.0f};  // added after that, display-linear
};

LightChange light_change(const glm::vec3& mixed, const glm::vec3& real, const ToneMap& tone_map,
                         RealSurfaces real_surfaces);

// The camera's radiance `seen` of a real surface that a ray met, changed likewise: L m / r, or
// L + m - r but at least 0. Scene-linear.
glm::vec3 change_radiance(const glm::vec3& seen, const glm::vec3& mixed, const glm::vec3& real,
                          const ToneMap& tone_map, RealSurfaces real_surfaces);

// TM(TM^-1(camera) q), display-linear, q >= 0. The exposure cancels. q = 1 gives the camera's color
// exactly. 1 stands for the least radiance that gives it.
glm::vec3 scale_light(const glm::vec3& camera, const glm::vec3& q, ToneCurve curve);

}  // namespace amalgam::scene
