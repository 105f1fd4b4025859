// How much of a light reaches a diffuse point: two attenuations at once, with and without what is
// virtual (section 4.3).
#pragma once

#include "trace/embree_scene.h"
#include "trace/work_items.h"

namespace amalgam::trace {

// start: the point in question; the ray lies on the line from there to the light and may begin a
// little later, off the surface. Follows the ray straight through transmissive surfaces until both
// attenuations are 0 or the light is reached. Glass takes 1 - Schlick at each surface, its base
// colour, and Beer-Lambert absorption between them (trace/fresnel.h). If nothing of the scene
// transmits light the first hit ends a solution.
ShadowAttenuation trace_shadow(const EmbreeScene& scene, const glm::dvec3& start, const Ray& ray);

}  // namespace amalgam::trace
