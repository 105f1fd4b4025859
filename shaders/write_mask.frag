#version 450 core
// The kind of surface that a sample sees: M_v and M_r.
#include "interface.glsl"
#include "surface_inputs.glsl"
#include "surface_material.glsl"

out uint flags;

void main() {
  if (is_cut_out(base_color())) discard;
  flags = surface_flags;
}
