// What a surface's vertices hand to its fragments (surface_attributes.glsl).
layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;  // not unit
layout(location = 2) in vec2 surface_uv;
#if HAS_VERTEX_COLORS
layout(location = 3) in vec4 surface_color;
#endif
#if HAS_NORMAL_TEXTURE
layout(location = 4) in vec4 mesh_tangent;
#endif
#if HAS_SECOND_UVS
layout(location = 5) in vec2 second_surface_uv;
#endif
