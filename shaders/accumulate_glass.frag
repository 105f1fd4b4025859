#version 450 core
// Adds one glass interface's optical depth to the light's path (see shadow.glsl), and keeps the
// nearest interface's depth.
#include "interface.glsl"
#include "surface_inputs.glsl"
#include "surface_material.glsl"
#include "surface_normals.glsl"
#include "shadow.glsl"


out vec4 depth_and_nearest;

void main() {
  vec4 color = base_color();
  if (is_cut_out(color)) discard;

  bool perspective = light_perspective != 0u;
  vec3 to_light = perspective ? normalize(light_eye - world_position) : light_eye;
  // Parallel light: from any origin, since only differences count.
  float t = perspective ? distance(light_eye, world_position) : -dot(to_light, world_position);

  Normals normals = surface_normals(world_normal);
  float through = transmission() * (1.0 - glass_reflectance(abs(dot(normals.shading, to_light))));
  vec3 depth = -log(max(through * color.rgb, vec3(kMinTransmittance)));
  if (material.thin == 0u) {
    depth += material.absorption * (dot(normals.geometric, to_light) > 0.0 ? -t : t);
  }
  depth_and_nearest = vec4(depth, gl_FragCoord.z);
}
