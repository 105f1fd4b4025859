#version 450 core
// Shadow casters, projected to one layer of the shadow maps.
#include "interface.glsl"
#include "surface_attributes.glsl"

void main() {
  write_surface_outputs();
  gl_Position = clip_from_world * vec4(world_position, 1.0);
}
