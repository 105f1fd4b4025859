// Attenuation of a light on its way to a diffuse point, both with and without virtual objects
// (section 4.3).
#pragma once

#include "trace/embree_scene.h"
#include "trace/work_items.h"

namespace amalgam::trace {

// start: the shaded point. The shadow ray lies on the line from start to the light and may begin a
// little before it. Light passes transmissive surfaces without bending. Each glass surface
// multiplies it by 1 - Schlick and its base color; Beer-Lambert absorption acts between surfaces
// (trace/fresnel.h). A ray that overflows `surfaces` counts as blocked. surfaces: scratch space,
// reused from ray to ray.
ShadowAttenuation trace_shadow(const EmbreeScene& scene, const glm::dvec3& start, const Ray& ray,
                               PassedSurfaces& surfaces);

// The same if virtual objects take some of the light. If they take none, real objects are not
// tested and both attenuations are 1.
ShadowAttenuation trace_shadow_change(const EmbreeScene& scene, const glm::dvec3& start,
                                      const Ray& ray, PassedSurfaces& surfaces);

}  // namespace amalgam::trace
