#version 450 core
// What kind of surface a sample sees: M_v and M_r.
#include "interface.glsl"
#include "base_color.glsl"

layout(location = 2) in vec2 surface_uv;
layout(location = 0) out uint flags;

void main() {
  if (is_cut_out(base_color(surface_uv))) discard;
  flags = surface_flags;
}
