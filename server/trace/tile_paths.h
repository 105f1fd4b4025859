// The traced result of one tile without the camera's colors. While nothing moves it stays valid,
// and only the colors are looked up again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace amalgam::trace {

// The light of one sample. Scene-linear, except that I_e is display-linear.
struct SampleResult {
  glm::vec3 mixed{0.0f};                   // I_m
  glm::vec3 real{0.0f};                    // I_r
  glm::vec3 environment_reflection{0.0f};  // I_e
  std::uint16_t pixel_x = 0, pixel_y = 0;  // of the picture
  bool met_virtual = false;                // M_v, eq. 4.9
  bool sees_real_diffuse = false;          // the primary ray does
  bool first_of_pixel = false;
};

// A real surface at the end of a ray, visible to the camera.
struct LookUp {
  glm::vec3 weight{0.0f};          // of its radiance in the sample
  std::uint32_t sample = 0;        // index into TilePaths::samples
  glm::vec2 pixel{0.0f};           // where the camera sees it; centres are integers
  float trust = 0.0f;              // CameraPlace::trust
  glm::vec3 modelled_mixed{0.0f};  // radiance without the camera, scene-linear
  glm::vec3 modelled_real{0.0f};
};

// The branches of one sample that were cut off, by the depth limit or the importance cut-off.
struct Truncation {
  glm::vec3 weight{0.0f};       // their shares of the sample's light
  glm::vec3 radiance{0.0f};     // the light that they took instead; contained in I_m
  glm::vec3 environment{0.0f};  // likewise in I_e
};

struct TilePaths {
  std::vector<SampleResult> samples;
  std::vector<LookUp> look_ups;  // not yet added to the samples
  // By sample; empty if no branch was cut off.
  std::vector<Truncation> truncations;

  std::size_t bytes() const {
    return samples.size() * sizeof(SampleResult) + look_ups.size() * sizeof(LookUp) +
           truncations.size() * sizeof(Truncation);
  }
};

}  // namespace amalgam::trace
