// Fresnel reflectance of a smooth surface and the direction of the refracted ray (eq. 4.7, 4.8).
#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace amalgam::trace {

enum class FresnelModel { Schlick, Exact };

// Interface between two dielectrics. cos_incident: cosine between the ray and the normal on the
// incident side, in [0, 1]. eta_incident, eta_transmitted: indices of refraction. Both return k_s
// in [0, 1]; k_t = 1 - k_s. Total internal reflection gives exactly 1.
//
// Schlick's polynomial takes the cosine on the *less dense* side (numerics A3, B3): with the cosine
// inside glass, eq. 4.7 would be wrong by up to 0.959. Equal indices give 0, because there is no
// interface; the polynomial would rise to 1 at grazing angles.
double reflectance_schlick(double cos_incident, double eta_incident, double eta_transmitted);
// Unpolarised Fresnel equations.
double reflectance_exact(double cos_incident, double eta_incident, double eta_transmitted);
double reflectance(FresnelModel model, double cos_incident, double eta_incident,
                   double eta_transmitted);

// Conductor: Schlick per channel with F0 the metal's base color.
glm::vec3 reflectance_conductor(const glm::vec3& f0, float cos_incident);

// A thin sheet of glass: both surfaces and all reflections between them, 2R / (1 + R).
double thin_sheet_reflectance(double surface_reflectance);

// Transmittance of one glass surface for a shadow ray, which is not bent: 1 - Schlick, with the
// cosine taken as if outside, so that total internal reflection darkens no part of a shadow. 1 if
// the index is that of air. The rasteriser's glass shadow maps use the same formula
// (shaders/shadow.glsl).
float shadow_transmittance(float cos_incident, float ior, bool thin);

// Snell's law. direction: unit, travelling; normal: unit, facing the ray. Nothing at total internal
// reflection, decided by sin^2 >= 1 before any root is taken (numerics B4). In double for that
// decision.
std::optional<glm::dvec3> refract(const glm::dvec3& direction, const glm::dvec3& normal,
                                  double eta_incident, double eta_transmitted);

glm::dvec3 reflect(const glm::dvec3& direction, const glm::dvec3& normal);

}  // namespace amalgam::trace
