#version 450 core
// One pixel's share of the composite's layers, averaged over its n x n samples (eq. 4.5).
#include "tone_map.glsl"

layout(binding = 6) uniform sampler2D mixed_image;
layout(binding = 7) uniform sampler2D real_image;
layout(location = 3) uniform int samples_per_side;
layout(location = 4) uniform float exposure;

layout(location = 0) out vec4 over;        // A, a
layout(location = 1) out vec4 difference;  // D; alpha: values replaced

// By the bits: compilers may take for granted that there are no NaN.
bool is_finite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }

vec3 replace_nonfinite(vec3 v, inout float replaced) {
  for (int i = 0; i < 3; ++i) {
    if (!is_finite(v[i])) {
      v[i] = 0.0;
      replaced += 1.0;
    }
  }
  return v;
}

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * samples_per_side;
  vec4 over_sum = vec4(0.0);
  vec3 difference_sum = vec3(0.0);
  float replaced = 0.0;
  for (int y = 0; y < samples_per_side; ++y) {
    for (int x = 0; x < samples_per_side; ++x) {
      vec4 mixed = texelFetch(mixed_image, first + ivec2(x, y), 0);
      vec4 real = texelFetch(real_image, first + ivec2(x, y), 0);
      precise vec3 mixed_display = tone_map(mixed.rgb, exposure);
      precise vec3 real_display = tone_map(real.rgb, exposure);
      if (mixed.a != 0.0) {
        over_sum += vec4(replace_nonfinite(mixed_display, replaced), 1.0);
      } else {
        precise vec3 change = mixed_display - real_display;
        difference_sum += replace_nonfinite(change, replaced);
      }
    }
  }
  float weight = 1.0 / float(samples_per_side * samples_per_side);
  over = over_sum * weight;
  difference = vec4(difference_sum * weight, replaced);
}
