#version 450 core
// Both solutions of a diffuse surface in one go: I_m with all shadows, I_r with those of real
// objects (eq. 4.6).
#define RECEIVES_SHADOWS
#include "interface.glsl"
#include "surface_inputs.glsl"
#include "surface_material.glsl"
#include "surface_normals.glsl"
#include "phong.glsl"
#include "shadow.glsl"

layout(early_fragment_tests) in;
layout(binding = 1) uniform usampler2D mask_flags;
layout(location = 1) uniform uint light_count;
layout(location = 3) uniform int mask_step;  // samples from one fragment to the next

layout(location = 0) out vec4 mixed_image;
layout(location = 1) out vec4 real_image;

const uint kVirtual = 1u;

// FEW_SUNS: there are at most eight lights, all of them directional.
void add_light(Light light, PhongTerms terms, Normals normals, vec3 view, inout vec3 mixed,
               inout vec3 real) {
  LightArrival arrival = light_arrival(light, world_position);
  float cosine = dot(normals.shading, arrival.to_light);
  if (!(cosine > 0.0) || !(dot(normals.geometric, arrival.to_light) > 0.0)) return;
  vec4 lookup = shadow_lookup(light, world_position, normals.geometric, arrival.to_light);
  Attenuation attenuation = shadow_attenuation(lookup);
  vec3 contribution = phong_contribution(terms, normals.shading, view, arrival, cosine);
  precise vec3 mixed_sum = mixed + contribution * attenuation.mixed;
  precise vec3 real_sum = real + contribution * attenuation.real;
  mixed = mixed_sum;
  real = real_sum;
}

void main() {
  // Of coincident surfaces the mask pass chose one; another kind must not show through.
  ivec2 sample_at = ivec2(gl_FragCoord.xy) * mask_step + mask_step / 2;
  if (texelFetch(mask_flags, sample_at, 0).r != surface_flags) discard;
  vec4 color = base_color();
  if (is_cut_out(color)) discard;

  vec3 view = normalize(eye_in_world - world_position);
  Normals normals = surface_normals(world_normal);
  if (dot(normals.geometric, view) < 0.0) {
    normals.geometric = -normals.geometric;
    normals.shading = -normals.shading;
  }
  PhongTerms terms = phong_terms(color.rgb, metallic_roughness());

  vec3 glow = emission();
  precise vec3 mixed = glow;
  precise vec3 real = glow;
#if FEW_SUNS
  // One by one: with an index that the compiler knows, software GL reads each light once for all
  // fragments. What is beyond the light count has no direction, and so adds nothing.
  add_light(lights[0], terms, normals, view, mixed, real);
  add_light(lights[1], terms, normals, view, mixed, real);
  add_light(lights[2], terms, normals, view, mixed, real);
  add_light(lights[3], terms, normals, view, mixed, real);
  add_light(lights[4], terms, normals, view, mixed, real);
  add_light(lights[5], terms, normals, view, mixed, real);
  add_light(lights[6], terms, normals, view, mixed, real);
  add_light(lights[7], terms, normals, view, mixed, real);
#else
  for (uint i = 0u; i < light_count; ++i) {
    add_light(lights[i], terms, normals, view, mixed, real);
  }
#endif
  bool is_virtual = (surface_flags & kVirtual) != 0u;
  mixed_image = vec4(mixed, is_virtual ? 1.0 : 0.0);
  real_image = is_virtual ? vec4(0.0) : vec4(real, 1.0);
}
