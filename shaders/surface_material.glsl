// The material at one point: its factors times its textures and vertex colors. trace/texels.h is
// the tracer's counterpart.
//
// HAS_*: the scene has the feature, and this program is for surfaces that may use it (a bit of
// material.textures says whether this one does). FROM_CAMERA: the textures' level of detail is that
// of a camera ray. Shadows read the full size, in both renderers.
#include "texture_lookup.glsl"

#if HAS_BASE_COLOR_TEXTURE
layout(binding = kBaseColorUnit) uniform usampler2D base_color_texture;
#endif
#if HAS_METALLIC_ROUGHNESS_TEXTURE
layout(binding = kMetallicRoughnessUnit) uniform usampler2D metallic_roughness_texture;
#endif
#if HAS_EMISSIVE_TEXTURE
layout(binding = kEmissiveUnit) uniform usampler2D emissive_texture;
#endif
#if HAS_TRANSMISSION_TEXTURE
layout(binding = kTransmissionUnit) uniform usampler2D transmission_texture;
#endif
#if HAS_NORMAL_TEXTURE
layout(binding = kNormalUnit) uniform usampler2D normal_texture;
#endif
#if HAS_SECOND_UVS
layout(std430, binding = kSecondUvAreasBinding) readonly buffer SecondUvAreas {
  float second_uv_areas[];
};
#endif

bool has_texture(uint slot) { return (material.textures >> slot & 1u) != 0u; }
bool reads_second_uvs(uint slot) {
  return (material.textures >> (slot + kSecondUvsBit) & 1u) != 0u;
}

float uv_footprint(float uv_area_per_mesh_area) {
#if FROM_CAMERA
  vec3 outside = mat3(normal_from_mesh) * face_normals[gl_PrimitiveID].xyz;
  float outside_length = length(outside);
  float world_area_per_mesh_area = outside_length * abs(normal_from_mesh[3][3]);
  vec3 to_eye = eye_in_world - world_position;
  float far = length(to_eye);
  float cosine = abs(dot(outside, to_eye)) / (outside_length * far);
  float side = sample_spread * far / max(cosine, kMinFootprintCosine);
  return uv_area_per_mesh_area / world_area_per_mesh_area * side * side;
#else
  return 0.0;
#endif
}

vec4 sample_slot(usampler2D map, uint slot, bool is_color) {
  const uint kWrapMask = (1u << kWrapBits) - 1u;
  uint wraps = material.wraps >> (2u * kWrapBits * slot);
  uvec2 wrap = uvec2(wraps & kWrapMask, wraps >> kWrapBits & kWrapMask);
  uint packed_size = slot == kNormalSlot ? material.normal_map_size : material.map_sizes[slot];
  ivec2 full = ivec2(packed_size & (1u << kMapSizeBits) - 1u, packed_size >> kMapSizeBits);
#if HAS_SECOND_UVS
  if (reads_second_uvs(slot)) {
    return sample_map(map, full, second_surface_uv, wrap,
                      uv_footprint(second_uv_areas[gl_PrimitiveID]), is_color);
  }
#endif
  return sample_map(map, full, surface_uv, wrap, uv_footprint(face_normals[gl_PrimitiveID].w),
                    is_color);
}

vec4 base_color() {
  vec4 color = material.base_color;
#if HAS_VERTEX_COLORS
  color *= surface_color;
#endif
#if HAS_BASE_COLOR_TEXTURE
  if (has_texture(kBaseColorSlot)) color *= sample_slot(base_color_texture, kBaseColorSlot, true);
#endif
  return color;
}

// Alpha cut-outs. A surface of constant alpha is visible as a whole or not drawn at all, so its
// shader has no discard and the driver may test depth before shading.
bool is_cut_out(vec4 color) {
#if HAS_BASE_COLOR_TEXTURE || HAS_VERTEX_COLORS
  return color.a < material.alpha_cutoff;
#else
  return false;
#endif
}

vec3 emission() {
#if HAS_EMISSIVE_TEXTURE
  if (has_texture(kEmissiveSlot))
    return material.emission * sample_slot(emissive_texture, kEmissiveSlot, true).rgb;
#endif
  return material.emission;
}

struct MetallicRoughness {
  float metallic;
  float phong_exponent;  // scene/material.cpp: phong_terms
};

MetallicRoughness metallic_roughness() {
#if HAS_METALLIC_ROUGHNESS_TEXTURE
  if (has_texture(kMetallicRoughnessSlot)) {
    vec4 texel = sample_slot(metallic_roughness_texture, kMetallicRoughnessSlot, false);
    float roughness = material.roughness * texel.g;
    float alpha = roughness * roughness;
    return MetallicRoughness(material.metallic * texel.b,
                             clamp(0.5 / max(alpha * alpha, kMinSquaredAlpha) - 0.5, 0.0,
                                   kMaxPhongExponent));
  }
#endif
  return MetallicRoughness(material.metallic, material.phong_exponent);
}

float transmission() {
#if HAS_TRANSMISSION_TEXTURE
  if (has_texture(kTransmissionSlot)) {
    return material.transmission *
           sample_slot(transmission_texture, kTransmissionSlot, false).r;
  }
#endif
  return material.transmission;
}

// normal: interpolated, unit, outward.
vec3 bent_normal(vec3 normal) {
#if HAS_NORMAL_TEXTURE
  if (!has_texture(kNormalSlot)) return normal;
  vec3 along = mat3(world_from_mesh) * mesh_tangent.xyz;
  vec3 flat_along = along - dot(along, normal) * normal;
  float flat_length = length(flat_along);
  if (!(flat_length > kMinTangentShare * length(along))) return normal;
  vec3 x = flat_along / flat_length;
  // A mirroring transform keeps the normal outward, which reverses the cross product.
  float mirrored = normal_from_mesh[3][3] < 0.0 ? -1.0 : 1.0;
  vec3 y = cross(normal, x) * (mesh_tangent.w < 0.0 ? -mirrored : mirrored);
  vec3 texel = 2.0 * sample_slot(normal_texture, kNormalSlot, false).xyz - 1.0;
  vec3 bent = texel.x * material.normal_scale * x + texel.y * material.normal_scale * y +
              texel.z * normal;
  float bent_length = length(bent);
  return bent_length > 0.0 ? bent / bent_length : normal;
#else
  return normal;
#endif
}
