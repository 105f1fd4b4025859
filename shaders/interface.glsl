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
  uint textures;          // bit n: has a texture in slot n; bit 8 + n: read at the second uvs
  uint wraps;             // 4 bits a slot: 0 repeat, 1 mirror, 2 clamp; u, then v
  float roughness;
  float transmission;
  float normal_scale;
  uvec4 map_sizes;        // by slot: width, and height in the upper half
  uint normal_map_size;
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

layout(std140, binding = 0) uniform Frame {
  vec3 eye_in_world;
  float sample_spread;    // angle between neighbouring samples, radians
};
layout(std140, binding = 1) uniform SrgbTable { vec4 srgb_table[64]; };
layout(std140, binding = 2) uniform Surface {
  mat4 clip_from_mesh;
  mat4 world_from_mesh;
  mat4 normal_from_mesh;  // cofactors, divided by the last element, which is negative if it mirrors
  Material material;
  uint surface_flags;     // what the mask shows
};
layout(std140, binding = 3) uniform Lights { Light lights[512]; };
layout(std140, binding = 4) uniform ShadowLayer {
  mat4 clip_from_world;
  vec3 light_eye;          // perspective: the light's position; parallel: unit vector to the light
  uint light_perspective;
};

layout(std430, binding = 0) readonly buffer FaceNormals {
  vec4 face_normals[];    // w: area in uv over area in mesh space
};
