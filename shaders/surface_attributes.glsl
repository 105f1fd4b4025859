// Vertex attributes of a surface, and their outputs to fragments (surface_inputs.glsl).
layout(location = kPositionAttribute) in vec3 position;
layout(location = kNormalAttribute) in vec3 normal;
layout(location = kUvAttribute) in vec2 uv;
out vec3 world_position;
out vec3 world_normal;  // not unit
out vec2 surface_uv;
#if HAS_VERTEX_COLORS
layout(location = kColorAttribute) in vec4 color;
out vec4 surface_color;
#endif
#if HAS_NORMAL_TEXTURE
layout(location = kTangentAttribute) in vec4 tangent;
out vec4 mesh_tangent;
#endif
#if HAS_SECOND_UVS
layout(location = kSecondUvAttribute) in vec2 second_uv;
out vec2 second_surface_uv;
#endif

void write_surface_outputs() {
  world_position = (world_from_mesh * vec4(position, 1.0)).xyz;
  world_normal = mat3(normal_from_mesh) * normal;
  surface_uv = uv;
#if HAS_VERTEX_COLORS
  surface_color = color;
#endif
#if HAS_NORMAL_TEXTURE
  mesh_tangent = tangent;
#endif
#if HAS_SECOND_UVS
  second_surface_uv = second_uv;
#endif
}
