#version 450 core
// Casters of shadows as a light sees them, in one layer of the shadow maps.
#include "interface.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;

layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;
layout(location = 2) out vec2 surface_uv;

void main() {
  vec4 world = world_from_mesh * vec4(position, 1.0);
  world_position = world.xyz;
  world_normal = mat3(normal_from_mesh) * normal;
  surface_uv = uv;
  gl_Position = clip_from_world * world;
}
