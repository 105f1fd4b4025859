// What rays do that meet glass (section 4.2): one part is mirrored, one goes through, and what a
// transmission factor or texture leaves of the rest comes back from the surface.
#include "support/reference/bent_normal.h"
#include "support/reference/whitted.h"

namespace amalgam::reference {
namespace {

// The largest roughness that does not count; materials hold it in float.
constexpr double kSmooth = double{0.2f};

struct GlassShares {
  double mirrored = 0.0;   // of the light from where the mirrored ray goes
  Color passing{0.0};      // of the light from where the refracted ray goes
  double scattered = 0.0;  // of the light that `phong` sends back
  Phong phong;
  bool rough = false;  // whether that made a difference
};

// k_s: reflectance of the polished surface, 1 at total internal reflection.
GlassShares share_out(const SurfaceMaterial& material, double k_s) {
  const Color color(material.base_color);
  const double opaque = 1.0 - material.transmission;
  GlassShares shares;
  shares.passing = (1.0 - k_s) * material.transmission * color;
  shares.rough = opaque > 0.0 && material.roughness > kSmooth;
  if (shares.rough) {
    // Where it is opaque it has a highlight in place of a mirror image.
    shares.mirrored = material.transmission * k_s;
    shares.scattered = opaque;
    shares.phong = phong_of(color, material.metallic, material.roughness);
  } else {
    shares.mirrored = k_s;
    shares.scattered = (1.0 - k_s) * opaque;
    shares.phong = lambertian(color);
  }
  return shares;
}

}  // namespace

void Whitted::meet_thin_glass(const Branch& branch, const Surface& surface, Collector& to) const {
  const Vec3 normal = mirror_normal(surface);
  const double cosine = std::min(1.0, glm::dot(normal, surface.to_viewer));
  const double ior = static_cast<double>(surface.object.material.ior);
  const double k_s = thin_reflectance(reflectance(in_.settings.fresnel, 1.0, ior, cosine));
  const GlassShares shares = share_out(surface.material, k_s);
  to.decisions.note(shares.rough ? 9 : 8);
  const Vec3 mirrored = reflect(branch.ray.direction, normal);
  spawn(child_of(branch, surface, mirrored, Color(shares.mirrored)), to);
  spawn(child_of(branch, surface, branch.ray.direction, shares.passing), to);
  add_scattered(branch, surface, shares.scattered, shares.phong, to);
}

void Whitted::meet_glass(const Branch& branch, const Surface& surface, Collector& to) const {
  const bool entering = is_front(branch.ray, surface.hit);
  const MediaStack beyond =
      entering ? branch.media.entered(surface.object) : branch.media.left(surface.object);
  // A back face without a way in: the ray started inside.
  const bool started_inside = !entering && branch.media.empty();
  const double n1 = started_inside ? static_cast<double>(surface.object.material.ior)
                                   : refractive_index(branch.media.innermost());
  const double n2 = refractive_index(beyond.innermost());

  const Vec3 normal = mirror_normal(surface);
  const double cosine = std::min(1.0, glm::dot(normal, surface.to_viewer));
  const auto refracted_direction = refract(branch.ray.direction, normal, n1, n2);
  const double k_s = refracted_direction ? reflectance(in_.settings.fresnel, n1, n2, cosine) : 1.0;
  const GlassShares shares = share_out(surface.material, k_s);
  to.decisions.note(shares.rough ? 9 : 8);
  const Vec3 mirrored = reflect(branch.ray.direction, normal);
  spawn(child_of(branch, surface, mirrored, Color(shares.mirrored)), to);
  if (refracted_direction) {
    const Vec3 below = sink_refracted(*refracted_direction, surface.geometric_normal);
    Branch refracted = child_of(branch, surface, below, shares.passing);
    refracted.media = beyond;
    // The radiance of medium n2 in medium n1: the cone widens or narrows.
    refracted.weight *= squared_index(branch.media) / squared_index(beyond);
    spawn(refracted, to);
  }
  add_scattered(branch, surface, shares.scattered, shares.phong, to);
}

// As it is modelled: what the camera sees there is mostly not this.
void Whitted::add_scattered(const Branch& branch, const Surface& surface, double share,
                            const Phong& phong, Collector& to) const {
  if (share == 0.0) return;
  const auto [m, r] = illuminate(phong, branch, surface, to);
  to.sample.mixed += share * branch.weight * m;
  if (surface.object.role == scene::Role::Real) to.sample.real += share * branch.weight * r;
}

}  // namespace amalgam::reference
