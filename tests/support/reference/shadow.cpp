#include "support/reference/shadow.h"

#include "support/reference/fresnel.h"

namespace amalgam::reference {
namespace {

// What the surfaces of one role do to light that passes them in a straight line.
struct Passage {
  Color factor{1.0};
  Color optical_depth{0.0};  // sum of sigma_a t, minus where glass begins, plus where it ends

  void add(const World& world, const Ray& ray, const Hit& hit) {
    const scene::Material& material = world.object(hit).material;
    if (material.kind != scene::MaterialKind::Dielectric) {
      factor = Color(0.0);
      return;
    }
    const SurfaceMaterial here = world.material(hit);
    const double ior = static_cast<double>(material.ior);
    const double cosine = std::abs(glm::dot(here.normal, ray.direction));
    double reflected = reflectance(Fresnel::Schlick, 1.0, ior, std::min(1.0, cosine));
    if (material.thin) {
      reflected = thin_reflectance(reflected);
    } else {
      const double sign = is_front(ray, hit) ? -1.0 : 1.0;
      optical_depth += sign * hit.t * Color(material.absorption);
    }
    factor *= here.transmission * (1.0 - reflected) * Color(here.base_color);
  }

  Color attenuation() const { return factor * glm::exp(-glm::max(optical_depth, Color(0.0))); }
};

}  // namespace

Shadow cast_shadow_ray(const World& world, const Vec3& point, const ArrivingLight& light,
                       Decisions& decisions) {
  const Ray ray = ray_from_surface(point, light.to_light, light.distance);
  Passage through_real, through_virtual;
  world.for_each_hit(ray, [&](const Hit& hit) {
    const bool real = world.object(hit).role == scene::Role::Real;
    (real ? through_real : through_virtual).add(world, ray, hit);
    decisions.note_unordered(2 * hit.object + (is_front(ray, hit) ? 1 : 0));
    return through_real.factor != Color(0.0);  // then both are dark
  });
  const Color real = through_real.attenuation();
  return {real * through_virtual.attenuation(), real};
}

}  // namespace amalgam::reference
