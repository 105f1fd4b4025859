// How much of a light reaches a diffuse point: two attenuations at once, with and without what is
// virtual (section 4.3).
#pragma once

#include "trace/embree_scene.h"
#include "trace/work_items.h"

namespace amalgam::trace {

// start: the point in question; the ray lies on the line from there to the light and may begin a
// little later, off the surface. The light goes straight through transmissive surfaces. Glass takes
// 1 - Schlick at each of them, its base color, and Beer-Lambert absorption between them
// (trace/fresnel.h). More surfaces than `surfaces` has room for count as opaque.
// surfaces: room for what the way meets, so that it need not be made for each ray.
ShadowAttenuation trace_shadow(const EmbreeScene& scene, const glm::dvec3& start, const Ray& ray,
                               PassedSurfaces& surfaces);

// The same where virtual objects take some of the light. Where they take none, what real ones take
// is not asked, and both attenuations are 1.
ShadowAttenuation trace_shadow_change(const EmbreeScene& scene, const glm::dvec3& start,
                                      const Ray& ray, PassedSurfaces& surfaces);

}  // namespace amalgam::trace
