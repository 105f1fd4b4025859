// How much light may change within a few texels of a shadow map around what a pixel sees, by the
// reference: next to a shadow's edge a map may say anything between lit and dark.
#pragma once

#include <vector>

#include "parity/parity_case.h"

namespace amalgam::parity {

class ShadowEdges {
 public:
  // The case must outlive this.
  explicit ShadowEdges(const ParityCase& parity_case);

  struct Surroundings {
    // To the nearest edge of a shadow, in texels of the map whose light's shadow it is, measured
    // across that light's direction; infinity if there is none within reach.
    double distance = reference::kInfinity;
    // Scene-linear: the most that I_m or I_r would change if each light were shadowed as it is
    // somewhere within reach.
    reference::Color change{0.0};
  };

  // Of the diffuse surface that the pixel's centre sees. reach: texels.
  Surroundings around(int x, int y, double reach) const;

 private:
  struct Seen;
  double texel(const scene::Light& light, const reference::Vec3& point) const;
  void look_around(const scene::Light& light, const Seen& seen, double reach,
                   Surroundings& result) const;

  const ParityCase& case_;
  reference::ReferenceRequest request_;
  reference::World world_;
  std::vector<reference::Vec3> extent_;  // corners of boxes that hold all that may shadow itself
  int map_side_ = 0;                     // texels
};

}  // namespace amalgam::parity
