// What a ray really meets. Embree traces in float and from a little off the surface that a ray
// leaves (trace/ray_offset.h); curved mirrors and glass magnify that, at each bounce again. The
// line itself is therefore kept in double, and only asked of Embree is which triangle it meets.
#pragma once

#include <glm/vec3.hpp>

#include "trace/embree_scene.h"

namespace amalgam::trace {

// Where the line meets the plane of the triangle that the hit names, also beside the triangle. Not
// finite where the line runs in the plane.
Hit in_plane_of(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& start,
                const glm::dvec3& direction);

// The hit of the line that begins at start, with barycentric coordinates and t (from start) in
// double: in the triangle that the traced ray met, or in its neighbour (of what is visible) if the
// line passes beside that one. Where the line passes beside both, their edge; where it has no point
// in common with the triangle that means anything (seen edge-on), the traced hit as it is.
//
// traced.t is from start as well, as well as float knows it.
Hit refine_hit(const EmbreeScene& scene, const Hit& traced, const glm::dvec3& start,
               const glm::dvec3& direction, Visible visible);

}  // namespace amalgam::trace
