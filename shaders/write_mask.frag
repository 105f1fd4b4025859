#version 450 core
// What kind of surface a sample sees: M_v and M_r.
#include "interface.glsl"
#include "base_color.glsl"

layout(location = 2) in vec2 surface_uv;
layout(location = 0) out uint flags;

void main() {
  Instance instance = instances[instance_index];
  Material material = materials[instance.material];
  if (is_cut_out(material, base_color(instance, material, surface_uv))) discard;
  flags = instance.flags;
}
