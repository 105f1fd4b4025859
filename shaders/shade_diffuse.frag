#version 450 core
// Both solutions of a diffuse surface at once: I_m with all shadows, I_r with those of real objects
// (eq. 4.6).
#define RECEIVES_SHADOWS
#include "interface.glsl"
#include "surface_inputs.glsl"
#include "surface_material.glsl"
#include "surface_normals.glsl"
#include "phong.glsl"
#include "shadow.glsl"

layout(early_fragment_tests) in;
layout(binding = kMaskUnit) uniform usampler2D mask_flags;
layout(location = kLightCountLocation) uniform uint light_count;
// Mask samples from one fragment to the next.
layout(location = kMaskStepLocation) uniform int mask_step;
// 1: all surfaces are white Lambertian ones without emission, for the meter.
layout(location = kWhiteSurfacesLocation) uniform int white_surfaces;

// For each tile: bit i is set if a virtual caster may occlude light i there.
layout(binding = kTileLightsUnit) uniform usampler2D tile_lights;
// Fragments along a tile's side.
layout(location = kSamplesOfTileLocation) uniform int samples_of_tile;

layout(location = kMixedOutput) out vec4 mixed_image;
layout(location = kRealOutput) out vec4 real_image;

struct DiffusePoint {
  PhongTerms terms;
  Normals normals;
  vec3 view;
};

// Adds a light's contribution. added: the transmittance of virtual objects.
void add_light(Light light, DiffusePoint point, vec3 added, inout vec3 mixed, inout vec3 real) {
  LightArrival arrival = light_arrival(light, world_position);
  float cosine = dot(point.normals.shading, arrival.to_light);
  if (!(cosine > 0.0) || !(dot(point.normals.geometric, arrival.to_light) > 0.0)) return;
  vec3 attenuation = real_attenuation(
      shadow_lookup(light, world_position, point.normals.geometric, arrival.to_light));
  vec3 contribution = phong_contribution(point.terms, point.normals.shading, point.view, arrival,
                                         cosine);
  precise vec3 mixed_sum = mixed + contribution * (attenuation * added);
  precise vec3 real_sum = real + contribution * attenuation;
  mixed = mixed_sum;
  real = real_sum;
}

vec3 added_attenuation(Light light, vec3 geometric_normal) {
  return virtual_attenuation(shadow_lookup(light, world_position, geometric_normal,
                                           light_arrival(light, world_position).to_light));
}

#if FEW_SUNS
// At most kFewSuns lights, all of them directional. The transmittance of virtual objects is
// computed in a loop over only those lights that a virtual caster may occlude in this tile:
// software GL executes both branches of an `if`, but it does end loops. The rest is unrolled: with
// a constant index, each light is read once for all fragments. Lights beyond the light count have
// no direction and add nothing.
void add_lights(DiffusePoint point, inout vec3 mixed, inout vec3 real) {
  uint waiting = texelFetch(tile_lights, ivec2(gl_FragCoord.xy) / samples_of_tile, 0).r;
  vec3 a0 = vec3(1.0), a1 = a0, a2 = a0, a3 = a0, a4 = a0, a5 = a0, a6 = a0, a7 = a0;
  do {
    uint i = waiting == 0u ? kFewSuns : uint(findLSB(waiting));
    vec3 added = added_attenuation(lights[i], point.normals.geometric);
    a0 = i == 0u ? added : a0;
    a1 = i == 1u ? added : a1;
    a2 = i == 2u ? added : a2;
    a3 = i == 3u ? added : a3;
    a4 = i == 4u ? added : a4;
    a5 = i == 5u ? added : a5;
    a6 = i == 6u ? added : a6;
    a7 = i == 7u ? added : a7;
    waiting &= waiting - 1u;
  } while (waiting != 0u);
  add_light(lights[0], point, a0, mixed, real);
  add_light(lights[1], point, a1, mixed, real);
  add_light(lights[2], point, a2, mixed, real);
  add_light(lights[3], point, a3, mixed, real);
  add_light(lights[4], point, a4, mixed, real);
  add_light(lights[5], point, a5, mixed, real);
  add_light(lights[6], point, a6, mixed, real);
  add_light(lights[7], point, a7, mixed, real);
}
#else
void add_lights(DiffusePoint point, inout vec3 mixed, inout vec3 real) {
  for (uint i = 0u; i < light_count; ++i) {
    add_light(lights[i], point, added_attenuation(lights[i], point.normals.geometric), mixed, real);
  }
}
#endif

void main() {
  // Of coincident surfaces the mask pass chose one. A surface of another kind must not show.
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
  DiffusePoint point =
      DiffusePoint(phong_terms(color.rgb, metallic_roughness()), normals, view);
  vec3 mixed = emission();
  if (white_surfaces != 0) {
    point.terms = PhongTerms(vec3(1.0), vec3(0.0), 1.0);
    mixed = vec3(0.0);
  }
  vec3 real = mixed;
  add_lights(point, mixed, real);
  bool is_virtual = (surface_flags & kVirtualFlag) != 0u;
  mixed_image = vec4(mixed, is_virtual ? 1.0 : 0.0);
  real_image = is_virtual ? vec4(0.0) : vec4(real, 1.0);
}
