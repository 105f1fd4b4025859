// What GLSL and C++ agree on; the other half of this file is server/gl/shader_interface.h.

struct Instance {
  mat4 clip_from_mesh;
  mat4 world_from_mesh;
  mat4 normal_from_mesh;  // cofactors
  uint material;
  uint flags;             // what the mask shows
  uint textured;
  uint unused;
};

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
  uint unused;
};

struct ShadowLayer {
  mat4 clip_from_world;
  vec3 eye;          // perspective: the light's position; parallel: unit vector to the light
  uint perspective;
  float texel;       // side of a texel, metres (perspective: at 1 m)
  uint unused[3];
};

layout(std140, binding = 0) uniform Frame { vec4 eye_in_world; };
layout(std140, binding = 1) uniform SrgbTable { vec4 srgb_table[64]; };

layout(std430, binding = 0) readonly buffer Instances { Instance instances[]; };
layout(std430, binding = 1) readonly buffer Materials { Material materials[]; };
layout(std430, binding = 2) readonly buffer FaceNormals { vec4 face_normals[]; };
layout(std430, binding = 3) readonly buffer Lights { Light lights[]; };
layout(std430, binding = 4) readonly buffer ShadowLayers { ShadowLayer shadow_layers[]; };

layout(location = 0) uniform uint instance_index;
