// A surface's vertices, and what of them goes on to its fragments (surface_inputs.glsl).
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 0) out vec3 world_position;
layout(location = 1) out vec3 world_normal;  // not unit: normalised where it is used
layout(location = 2) out vec2 surface_uv;
#if HAS_VERTEX_COLORS
layout(location = 3) in vec4 color;
layout(location = 3) out vec4 surface_color;
#endif
#if HAS_NORMAL_TEXTURE
layout(location = 4) in vec4 tangent;
layout(location = 4) out vec4 mesh_tangent;
#endif
#if HAS_SECOND_UVS
layout(location = 5) in vec2 second_uv;
layout(location = 5) out vec2 second_surface_uv;
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
