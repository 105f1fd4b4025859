#version 450 core
// Depth only; alpha masks leave holes.
#include "interface.glsl"
#include "base_color.glsl"

layout(location = 2) in vec2 surface_uv;

void main() {
  if (is_cut_out(base_color(surface_uv))) discard;
}
