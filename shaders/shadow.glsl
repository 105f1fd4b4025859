// Transmittance from a light to a receiver, by shadow maps.
//
// Opaque casters (mirrors too): 0 if one is nearer to the light. Four texels are compared and
// linearly weighted. Each is compared with the depth that the receiver's plane has at the texel's
// centre, and not with the receiver's own: a plane that is inclined to the light would else occlude
// itself, and moving the look-up off the surface instead would move the shadow's edge with it.
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
layout(binding = kShadowMapUnit + kRealOpaque) uniform sampler2DArray real_opaque_map;
layout(binding = kShadowMapUnit + kVirtualOpaque) uniform sampler2DArray virtual_opaque_map;
layout(binding = kShadowMapUnit + kRealGlass) uniform sampler2DArray real_glass_map;
layout(binding = kShadowMapUnit + kVirtualGlass) uniform sampler2DArray virtual_glass_map;
layout(location = kShadowMapsPresentLocation) uniform uint shadow_maps_present;

bool has_map(uint casters) { return (shadow_maps_present >> casters & 1u) != 0u; }

struct ShadowLookup {
  vec3 at;     // xy in the map, in units of its side; layer
  float depth; // reversed, of the receiver
  vec2 slope;  // how that changes along the receiver's plane, from texel to texel of opaque maps
};

vec3 row(mat4 m, int i) { return vec3(m[0][i], m[1][i], m[2][i]); }

const float kRounding = 1e-5;  // of depth, [0, 1]; perspective depth: relative

// A step across the light along x or y of the map needs a step along the light to stay on the
// receiver's plane, and that changes depth.
ShadowLookup parallel_lookup(Light light, vec3 point, vec3 normal, float cosine) {
  vec2 across = vec2(dot(normal, row(light.clip_from_world, 0)),
                     dot(normal, row(light.clip_from_world, 1)));
  vec3 clip = (light.clip_from_world * vec4(point, 1.0)).xyz;
  return ShadowLookup(vec3(0.5 * clip.xy + 0.5, float(light.first_layer)), clip.z + kRounding,
                      (-light.plane_step / cosine) * across);
}

#if !FEW_SUNS
// The side of a cube that a direction points to (+x -x +y -y +z -z), and its clip coordinates
// there, with the other two axes in cyclic order. across: the same two of the normal.
vec4 cube_clip(vec3 d, vec3 normal, float tangent, float near, out uint side, out vec2 across) {
  vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z) {
    side = d.x >= 0.0 ? 0u : 1u;
    across = normal.yz / tangent;
    return vec4(d.yz / tangent, near, a.x);
  }
  if (a.y >= a.z) {
    side = d.y >= 0.0 ? 2u : 3u;
    across = normal.zx / tangent;
    return vec4(d.zx / tangent, near, a.y);
  }
  side = d.z >= 0.0 ? 4u : 5u;
  across = normal.xy / tangent;
  return vec4(d.xy / tangent, near, a.z);
}

// Seen from the light in the direction d, with d = 1 along the map's axis, the plane with the
// normal n through the point q has the depth near n.d / n.q, which is linear in d.
ShadowLookup perspective_lookup(Light light, vec3 point, vec3 normal, float cosine) {
  uint side = 0u;
  vec4 clip;
  vec2 across;
  vec3 q = point - light.position;
  if (light.layer_count == kCubeSides) {
    clip = cube_clip(q, normal, light.clip_from_world[0][0], kNearPlane, side, across);
  } else {
    clip = light.clip_from_world * vec4(point, 1.0);
    across = vec2(dot(normal, row(light.clip_from_world, 0)),
                  dot(normal, row(light.clip_from_world, 1)));
  }
  // Behind a spot light: unlit anyway.
  if (!(clip.w > 0.0)) return ShadowLookup(vec3(0.5, 0.5, 0.0), 2.0, vec2(0.0));
  vec3 ndc = clip.xyz / clip.w;
  vec2 slope = (-light.plane_step / (cosine * length(q))) * across;
  return ShadowLookup(vec3(0.5 * ndc.xy + 0.5, float(light.first_layer + side)),
                      ndc.z * (1.0 + kRounding), slope);
}
#endif

ShadowLookup shadow_lookup(Light light, vec3 point, vec3 geometric_normal, vec3 to_light) {
  // What this leaves uncorrected is covered by the casters' own offset (gl/pipeline_state.cpp).
  float cosine = max(dot(geometric_normal, to_light), kLeastShadowCosine);
#if !FEW_SUNS
  if (light.kind != kDirectionalLight) {
    return perspective_lookup(light, point, geometric_normal, cosine);
  }
#endif
  return parallel_lookup(light, point, geometric_normal, cosine);
}

// As a + f (b - a): exactly 1 between ones. Otherwise rounding would change the mixed image far
// from virtual casters.
float opaque_attenuation(sampler2DArray map, ShadowLookup lookup) {
  float size = float(textureSize(map, 0).x);
  vec2 p = lookup.at.xy * size - 0.5;
  vec2 whole = floor(p);
  vec2 f = p - whole;
  // Texels (0, 1), (1, 1), (1, 0), (0, 0).
  vec4 stored = textureGather(map, vec3((whole + 1.0) * (1.0 / size), lookup.at.z));
  vec4 depth = lookup.depth - dot(f, lookup.slope) +
               vec4(lookup.slope.y, lookup.slope.x + lookup.slope.y, lookup.slope.x, 0.0);
  vec4 lit = vec4(greaterThanEqual(max(depth, 0.0), stored));  // 0: no caster
  vec2 sides = lit.wx + f.x * (lit.zy - lit.wx);
  return sides.x + f.y * (sides.y - sides.x);
}

vec3 glass_texel(sampler2DArray map, ivec3 at, float depth) {
  ivec2 size = textureSize(map, 0).xy;
  if (any(lessThan(at.xy, ivec2(0))) || any(greaterThanEqual(at.xy, size))) return vec3(1.0);
  vec4 stored = texelFetch(map, at, 0);
  return depth >= stored.a ? vec3(1.0) : exp(-max(stored.rgb, 0.0));
}

vec3 glass_attenuation(sampler2DArray map, ShadowLookup lookup) {
  vec2 p = lookup.at.xy * vec2(textureSize(map, 0).xy) - 0.5;
  vec2 whole = floor(clamp(p, -2.0, 65536.0));
  vec2 f = clamp(p - whole, 0.0, 1.0);
  ivec3 at = ivec3(ivec2(whole), int(lookup.at.z));
  vec3 a = glass_texel(map, at, lookup.depth);
  vec3 b = glass_texel(map, at + ivec3(1, 0, 0), lookup.depth);
  vec3 c = glass_texel(map, at + ivec3(0, 1, 0), lookup.depth);
  vec3 d = glass_texel(map, at + ivec3(1, 1, 0), lookup.depth);
  // As a + f (b - a): exactly 1 between ones.
  vec3 top = a + f.x * (b - a);
  vec3 bottom = c + f.x * (d - c);
  return top + f.y * (bottom - top);
}

// IS_LONE_PLANE: the surface is flat and the only real opaque one, so no real opaque caster shadows
// it.
vec3 real_attenuation(ShadowLookup lookup) {
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
vec3 virtual_attenuation(ShadowLookup lookup) {
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
