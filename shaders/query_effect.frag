#version 450 core
// Survives where something virtual shows: on a virtual surface, or where I_m and I_r differ.
layout(binding = 6) uniform sampler2D mixed_image;
layout(binding = 7) uniform sampler2D real_image;

void main() {
  vec4 mixed = texelFetch(mixed_image, ivec2(gl_FragCoord.xy), 0);
  vec3 real = texelFetch(real_image, ivec2(gl_FragCoord.xy), 0).rgb;
  if (mixed.a == 0.0 && mixed.rgb == real) discard;
}
