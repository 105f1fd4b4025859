// Refines Embree's hits to double precision. Embree traces in float, from an origin a little off
// the surface that the ray leaves (trace/ray_offset.h). Curved mirrors and glass magnify both
// errors at each bounce. The ray's exact line is therefore kept in double, Embree only finds the
// triangle, and the point is computed here.
#pragma once

#include <glm/vec3.hpp>

#include "trace/embree_scene.h"

namespace amalgam::trace {

// Intersection of the line with the plane of the hit's triangle; it may lie outside the triangle.
// Not finite if the line is parallel to the plane.
Hit in_plane_of(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& start,
                const glm::dvec3& direction);

// Whether the hit is of the surface that the line leaves, or of one behind it: in double, the line
// meets the triangle's plane at start or before. ray: lies on the line and begins an offset
// before start (SurfacePoint::ray_origin_on_line). hit.t is from the ray's origin.
bool is_left_behind(const EmbreeScene& scene, const Hit& hit, const glm::dvec3& start,
                    const Ray& ray);

// The hit of the line from start, with barycentric coordinates and t (from start) in double. It
// lies in the traced triangle, or in the one that the line meets instead. If it meets none, the hit
// lies on the nearest point of the edge. If the triangle is seen edge-on, or missed by far and
// there is no other, the traced hit is returned unchanged.
//
// traced.t is from start too, with float's error.
Hit refine_hit(const EmbreeScene& scene, const Hit& traced, const glm::dvec3& start,
               const glm::dvec3& direction, Visible visible);

}  // namespace amalgam::trace
