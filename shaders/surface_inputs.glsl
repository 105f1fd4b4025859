// Inputs of a surface's fragments from its vertices (surface_attributes.glsl).
in vec3 world_position;
in vec3 world_normal;  // not unit
in vec2 surface_uv;
#if HAS_VERTEX_COLORS
in vec4 surface_color;
#endif
#if HAS_NORMAL_TEXTURE
in vec4 mesh_tangent;
#endif
#if HAS_SECOND_UVS
in vec2 second_surface_uv;
#endif
