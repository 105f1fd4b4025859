#version 450 core
// Surfaces as the camera sees them. All passes from the camera use this one shader, so that what one
// of them found to be nearest is found again to the last bit.
#include "interface.glsl"
#include "surface_attributes.glsl"

invariant gl_Position;

void main() {
  write_surface_outputs();
  gl_Position = clip_from_mesh * vec4(position, 1.0);
}
