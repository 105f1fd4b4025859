// What GLSL and C++ agree on; the other half of this file is server/gl/shader_interface.h.

struct Material {
  vec4 base_color;
  vec3 emission;
  float metallic;
  vec3 absorption;  // 1/m
  float alpha_cutoff;
  float phong_exponent;
  float normal_reflectance;
  uint thin;
  uint unused;
  uvec2 wrap;
  uvec2 unused2;
};

struct Light {
  vec3 to_light;
  uint kind;  // 0 directional, 1 point, 2 spot
  vec3 position;
  float range;
  vec3 intensity;
  float cos_inner;
  float cos_outer;
  uint first_layer;
  uint layer_count;
  float texel;           // side of a texel, metres (perspective: at 1 m)
  mat4 clip_from_world;  // a cube: [0][0] is the tangent of its sides' half angle
};

layout(std140, binding = 0) uniform Frame { vec4 eye_in_world; };
layout(std140, binding = 1) uniform SrgbTable { vec4 srgb_table[64]; };
layout(std140, binding = 2) uniform Surface {
  mat4 clip_from_mesh;
  mat4 world_from_mesh;
  mat4 normal_from_mesh;  // cofactors
  Material material;
  uint surface_flags;     // what the mask shows
};
layout(std140, binding = 3) uniform Lights { Light lights[512]; };
layout(std140, binding = 4) uniform ShadowLayer {
  mat4 clip_from_world;
  vec3 light_eye;          // perspective: the light's position; parallel: unit vector to the light
  uint light_perspective;
};

layout(std430, binding = 0) readonly buffer FaceNormals { vec4 face_normals[]; };
