// Normals at a fragment, in the world frame, both outward.

struct Normals {
  vec3 geometric;  // unit, of the triangle
  vec3 shading;    // unit, interpolated, bent by a normal texture
};

Normals surface_normals(vec3 interpolated) {
  Normals normals;
  normals.geometric =
      normalize(mat3(normal_from_mesh) * face_normals[gl_PrimitiveID].xyz);
  float len = length(interpolated);
  normals.shading = bent_normal(len > 0.0 ? interpolated / len : normals.geometric);
  return normals;
}
