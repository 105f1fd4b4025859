// The interface of GLSL and C++; server/gl/shader_interface.h is its counterpart. Numbers come from
// there by name: server/gl/shader_constants.cpp puts them before this text.

struct Material {
  vec4 base_color;
  vec3 emission;
  float metallic;
  vec3 absorption;  // 1/m
  float alpha_cutoff;
  float phong_exponent;
  float normal_reflectance;
  uint thin;
  uint textures;          // bit n: has a texture in slot n; kSecondUvsBit + n: at second uvs
  uint wraps;             // kWrapBits each: u, then v, slot after slot
  float roughness;
  float transmission;
  float normal_scale;
  uvec4 map_sizes;        // by slot: width, and height above kMapSizeBits
  uint normal_map_size;
};

struct Light {
  vec3 to_light;
  uint kind;
  vec3 position;
  float range;
  vec3 intensity;
  float cos_inner;
  float cos_outer;
  uint first_layer;
  uint layer_count;
  float plane_step;      // see shadow.glsl
  mat4 clip_from_world;  // a cube: [0][0] is the tangent of its sides' half angle
};

layout(std140, binding = kFrameBinding) uniform Frame {
  vec3 eye_in_world;
  float sample_spread;    // angle between neighbouring samples, radians
};
layout(std140, binding = kSrgbTableBinding) uniform SrgbTable {
  vec4 srgb_table[kSrgbTableSize / 4u];
};
layout(std140, binding = kSurfaceBinding) uniform Surface {
  mat4 clip_from_mesh;
  mat4 world_from_mesh;
  mat4 normal_from_mesh;  // cofactors, divided by the last element, negative if it mirrors
  Material material;
  uint surface_flags;     // the instance's value in the mask
};
layout(std140, binding = kLightsBinding) uniform Lights { Light lights[kMaxLights]; };
layout(std140, binding = kShadowLayerBinding) uniform ShadowLayer {
  mat4 clip_from_world;
  vec3 light_eye;          // perspective: the light's position; parallel: unit vector to the light
  uint light_perspective;
};

layout(std430, binding = kFaceNormalsBinding) readonly buffer FaceNormals {
  vec4 face_normals[];    // w: area in uv over area in mesh space
};
