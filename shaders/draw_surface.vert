#version 450 core
// Surfaces, projected to the camera. All passes from the camera use this one shader, so that their
// depths are equal to the last bit.
#include "interface.glsl"
#include "surface_attributes.glsl"

invariant gl_Position;

void main() {
  write_surface_outputs();
  gl_Position = clip_from_mesh * vec4(position, 1.0);
}
