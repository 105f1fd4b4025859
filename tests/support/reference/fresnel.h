// How much a surface between two transparent media reflects, and where the rest goes.
#pragma once

#include <optional>

#include "support/reference/vectors.h"

namespace amalgam::reference {

enum class Fresnel { Schlick, Exact };

// ((n - 1) / (n + 1))^2 with n = n2 / n1: R_m of eq. 4.7.
double normal_reflectance(double n1, double n2);

// Eq. 4.7: r + (1 - r) (1 - cosine)^5.
double schlick(double normal_reflectance, double cosine);
Color schlick(const Color& normal_reflectance, double cosine);

// Unpolarised light from medium n1 onto n2; 1 at total internal reflection. cos_incident in [0, 1].
double exact_reflectance(double n1, double n2, double cos_incident);

// The same by either model. Schlick takes the cosine of the less dense side, which inside glass is
// the transmitted one (numerics A3, B3).
double reflectance(Fresnel model, double n1, double n2, double cos_incident);

// A sheet without thickness has two surfaces whose reflections add up: 2 R / (1 + R).
double thin_reflectance(double reflectance);

// Cosine of the transmitted ray (Snell); nothing at total internal reflection.
std::optional<double> transmitted_cosine(double n1, double n2, double cos_incident);

// Unit direction after refraction; normal faces the ray (dot(direction, normal) <= 0).
std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, double n1, double n2);

Vec3 reflect(const Vec3& direction, const Vec3& normal);

}  // namespace amalgam::reference
