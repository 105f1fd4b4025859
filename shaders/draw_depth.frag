#version 450 core
// Depth only, with alpha cut-outs.
#include "interface.glsl"
#include "surface_inputs.glsl"
#include "surface_material.glsl"


void main() {
  if (is_cut_out(base_color())) discard;
}
