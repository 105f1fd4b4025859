#version 450 core
// Depth only; alpha masks leave holes.
#include "interface.glsl"
#include "base_color.glsl"

layout(location = 2) in vec2 surface_uv;

void main() {
  Instance instance = instances[instance_index];
  Material material = materials[instance.material];
  if (is_cut_out(material, base_color(instance, material, surface_uv))) discard;
}
