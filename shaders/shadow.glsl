// Transmittance from a light to a receiver, by shadow maps.
//
// Opaque casters (mirrors too): 0 if one is nearer to the light. Four depth comparisons, linearly
// weighted.
//
// Glass casters transmit light without bending it. The light's path through a map's texel meets
// interfaces i. Each transmits (1 - F_i) times the base color c_i, and solids absorb by
// Beer-Lambert:
//
//   optical depth = sum_i -ln((1 - F_i) c_i)  +  sum_i s_i sigma_i t_i,    T = exp(-max(depth, 0))
//
// with t the distance along the light, and s = -1 at an entering interface and +1 at a leaving one,
// so that interfaces need no pairing. F is Schlick's reflectance with the cosine |N.L| as if from
// outside, so that total internal reflection darkens no part of a shadow. For the two sides of thin
// glass together, F = 2R / (1 + R), without absorption. (1 - F) c is kept above kMinTransmittance.
// The tracer's shadow rays do the same (trace/shadow.cpp), with one difference: here a receiver
// behind the *nearest* glass gets the product of all glass on its texel, even of glass behind the
// receiver.

const float kMinTransmittance = 1e-6;

// F of one interface (solid), or of a whole sheet (thin).
float glass_reflectance(float cosine) {
  float m = clamp(1.0 - cosine, 0.0, 1.0);
  float r0 = material.normal_reflectance;
  if (r0 == 0.0) return 0.0;  // index of air: no interface
  float r = r0 + (1.0 - r0) * m * m * m * m * m;
  return material.thin != 0u ? 2.0 * r / (1.0 + r) : r;
}

#ifdef RECEIVES_SHADOWS
layout(binding = kShadowMapUnit + kRealOpaque) uniform sampler2DArrayShadow real_opaque_map;
layout(binding = kShadowMapUnit + kVirtualOpaque) uniform sampler2DArrayShadow virtual_opaque_map;
layout(binding = kShadowMapUnit + kRealGlass) uniform sampler2DArray real_glass_map;
layout(binding = kShadowMapUnit + kVirtualGlass) uniform sampler2DArray virtual_glass_map;
layout(location = kShadowMapsPresentLocation) uniform uint shadow_maps_present;

bool has_map(uint casters) { return (shadow_maps_present >> casters & 1u) != 0u; }

// The side of a cube that a direction points to (+x -x +y -y +z -z), and its clip coordinates
// there, with the other two axes in cyclic order.
vec4 cube_clip(vec3 d, float tangent, float near, out uint side) {
  vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z) {
    side = d.x >= 0.0 ? 0u : 1u;
    return vec4(d.yz / tangent, near, a.x);
  }
  if (a.y >= a.z) {
    side = d.y >= 0.0 ? 2u : 3u;
    return vec4(d.zx / tangent, near, a.y);
  }
  side = d.z >= 0.0 ? 4u : 5u;
  return vec4(d.xy / tangent, near, a.z);
}

// The look-up of a receiver: xy in the map, layer, reversed depth.
vec4 shadow_lookup(Light light, vec3 point, vec3 geometric_normal, vec3 to_light) {
  float texel = light.texel;
  if (light.kind != kDirectionalLight) texel *= distance(point, light.position);
  // A plane at angle a to the light changes its depth by d tan(a) within d. A step of d sin(a)
  // along its normal compensates. d: half a texel's diagonal and the filter's reach.
  float cosine = dot(geometric_normal, to_light);
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  vec3 lifted = point + geometric_normal * (kShadowLift * texel * sine);

  uint side = 0u;
  vec4 clip = light.clip_from_world * vec4(lifted, 1.0);
  if (light.layer_count == kCubeSides) {
    clip = cube_clip(lifted - light.position, light.clip_from_world[0][0], kNearPlane, side);
  }
  const float kRounding = 1e-5;  // of depth, [0, 1]; perspective depth: relative
  vec3 ndc = clip.xyz / clip.w;
  float depth = light.kind == kDirectionalLight ? ndc.z + kRounding : ndc.z * (1.0 + kRounding);
  // Behind a spot light: unlit anyway.
  if (!(clip.w > 0.0)) return vec4(0.5, 0.5, 0.0, 2.0);
  return vec4(0.5 * ndc.xy + 0.5, float(light.first_layer + side), depth);
}

float opaque_attenuation(sampler2DArrayShadow map, vec4 lookup) {
  // "Fully lit" must be exactly 1. Otherwise rounding of the filter's weights would change the
  // mixed image far from virtual casters.
  float lit = texture(map, lookup);
  return lit > 0.999 ? 1.0 : lit;
}

vec3 glass_texel(sampler2DArray map, ivec3 at, float depth) {
  ivec2 size = textureSize(map, 0).xy;
  if (any(lessThan(at.xy, ivec2(0))) || any(greaterThanEqual(at.xy, size))) return vec3(1.0);
  vec4 stored = texelFetch(map, at, 0);
  return depth >= stored.a ? vec3(1.0) : exp(-max(stored.rgb, 0.0));
}

vec3 glass_attenuation(sampler2DArray map, vec4 lookup) {
  vec2 p = lookup.xy * vec2(textureSize(map, 0).xy) - 0.5;
  vec2 whole = floor(clamp(p, -2.0, 65536.0));
  vec2 f = clamp(p - whole, 0.0, 1.0);
  ivec3 at = ivec3(ivec2(whole), int(lookup.z));
  vec3 a = glass_texel(map, at, lookup.w), b = glass_texel(map, at + ivec3(1, 0, 0), lookup.w);
  vec3 c = glass_texel(map, at + ivec3(0, 1, 0), lookup.w);
  vec3 d = glass_texel(map, at + ivec3(1, 1, 0), lookup.w);
  // As a + f (b - a): exactly 1 between ones.
  vec3 top = a + f.x * (b - a);
  vec3 bottom = c + f.x * (d - c);
  return top + f.y * (bottom - top);
}

// IS_LONE_PLANE: the surface is flat and the only real opaque one, so no real opaque caster shadows
// it.
vec3 real_attenuation(vec4 lookup) {
  vec3 real = vec3(1.0);
#if HAS_REAL_OPAQUE && !IS_LONE_PLANE
  if (has_map(kRealOpaque)) real *= opaque_attenuation(real_opaque_map, lookup);
#endif
#if HAS_REAL_GLASS
  if (has_map(kRealGlass)) real *= glass_attenuation(real_glass_map, lookup);
#endif
  return real;
}

// Transmittance of virtual objects. The mixed image's attenuation is the product of both, so
// without a virtual shadow it equals the real one to the last bit.
vec3 virtual_attenuation(vec4 lookup) {
  vec3 added = vec3(1.0);
#if HAS_VIRTUAL_OPAQUE
  if (has_map(kVirtualOpaque)) added *= opaque_attenuation(virtual_opaque_map, lookup);
#endif
#if HAS_VIRTUAL_GLASS
  if (has_map(kVirtualGlass)) added *= glass_attenuation(virtual_glass_map, lookup);
#endif
  return added;
}
#endif
