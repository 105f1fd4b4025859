#version 450 core
// Surfaces as the camera sees them. All passes from the camera use this one shader, so that what one
// of them found to be nearest is found again to the last bit.
#include "interface.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;

invariant gl_Position;
layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;  // not unit: normalised where it is used
layout(location = 2) out vec2 surface_uv;

void main() {
  world_position = (world_from_mesh * vec4(position, 1.0)).xyz;
  world_normal = mat3(normal_from_mesh) * normal;
  surface_uv = uv;
  gl_Position = clip_from_mesh * vec4(position, 1.0);
}
