#include "support/reference/whitted.h"

#include "support/reference/arriving_light.h"
#include "support/reference/bent_normal.h"
#include "support/reference/pictures.h"
#include "support/reference/real_change.h"
#include "support/reference/shadow.h"

namespace amalgam::reference {
namespace {

// Scene-linear. A hundred lights of that little each are far from what comparisons tell apart
// (relative_error.h: kDarkest times a thousandth).
constexpr double kNegligible = 1e-7;

// A medium's surface throws light back onto what it came from, again and again: a geometric series
// of albedo times the share of diffuse light that the surface reflects inwards. L / n^2 tells that
// share from the one reflected outwards, which is Schlick's formula over the hemisphere.
Color gain_within(double n, const Phong& phong) {
  if (n == 1.0) return Color(1.0);
  const double reflected_outside =
      schlick(normal_reflectance(1.0, n), 1.0) + (1.0 - normal_reflectance(1.0, n)) / 21.0;
  const double reflected_inside = 1.0 - (1.0 - reflected_outside) / (n * n);
  const Color albedo = glm::min(phong.albedo + phong.specular, Color(1.0));
  return Color(1.0) / (Color(1.0) - albedo * reflected_inside);
}

}  // namespace

Sample Whitted::trace(const Ray& primary, Decisions& decisions) const {
  Sample sample;
  Collector to{sample, decisions};
  follow({.ray = primary, .media = in_.start_media}, to);
  return sample;
}

void Whitted::follow(const Branch& branch, Collector& to) const {
  const auto hit = in_.world.closest(branch.ray);
  to.decisions.note(hit ? 2 * hit->object + (is_front(branch.ray, *hit) ? 3 : 2) : 0);
  if (in_.settings.lift > 0.0 && branch.depth > 0) note_lift(branch, hit, to);
  if (!hit) {
    // What the camera sees directly is in its image already.
    if (branch.depth > 0) add_environment(branch, to);
    return;
  }

  Branch arrived = branch;
  if (const Object* medium = branch.media.innermost()) {
    arrived.weight *= glm::exp(-Color(medium->material.absorption) * hit->t);
  }
  const Object& object = in_.world.object(*hit);
  const double side = is_front(branch.ray, *hit) ? 1.0 : -1.0;
  const SurfaceMaterial material = in_.world.material(*hit);
  const Surface surface{
      *hit,    object, side * hit->geometric_normal, side * material.normal, -branch.ray.direction,
      material};
  if (object.role == scene::Role::Virtual) to.sample.met_virtual = true;
  if (object.material.kind == scene::MaterialKind::Diffuse) {
    // Seen directly it is as a rasteriser draws it: media count from the first mirror or glass on.
    if (branch.depth == 0) to.sample.real_diffuse_first = object.role == scene::Role::Real;
    add_diffuse(branch.depth == 0 ? branch : arrived, surface, to);
    return;
  }

  if (branch.depth == 0) to.sample.specular_first = true;
  const Color glow = arrived.weight * surface.material.emission;
  to.sample.mixed += glow;
  if (object.role == scene::Role::Real) to.sample.real += glow;
  if (object.material.kind == scene::MaterialKind::Mirror) {
    meet_mirror(arrived, surface, to);
  } else if (object.material.thin) {
    meet_thin_glass(arrived, surface, to);
  } else {
    meet_glass(arrived, surface, to);
  }
}

void Whitted::note_lift(const Branch& branch, const std::optional<Hit>& hit, Collector& to) const {
  Ray lifted = branch.ray;
  lifted.origin += branch.lift;
  const auto other = in_.world.closest(lifted);
  const bool same = hit && other ? hit->object == other->object &&
                                       is_front(branch.ray, *hit) == is_front(lifted, *other)
                                 : !hit && !other;
  if (!same) to.decisions.note_unsure();
}

void Whitted::spawn(const Branch& child, Collector& to) const {
  // As seen from the camera's medium, where light of a denser one is spread over a wider cone.
  const double importance =
      largest_channel(child.weight) * squared_index(child.media) / squared_index(in_.start_media);
  if (importance == 0.0) return to.decisions.note(1);
  if (child.depth > in_.settings.max_depth || importance < in_.settings.importance_cutoff) {
    to.decisions.note(2);
    return add_environment(child, to);
  }
  to.decisions.note(3);
  follow(child, to);
}

void Whitted::add_environment(const Branch& branch, Collector& to) const {
  if (in_.environment == nullptr) return;
  // It is given as in air. A branch that ends within a medium takes it as it would be there.
  const Color light = squared_index(branch.media) * branch.weight *
                      environment_towards(*in_.environment, branch.ray.direction);
  if (in_.environment->low_dynamic_range) {
    to.sample.environment_reflection += light;  // must not be tone-mapped (section 4.4)
  } else {
    to.sample.mixed += light;
    to.sample.real += light;
  }
}

void Whitted::add_diffuse(const Branch& branch, const Surface& surface, Collector& to) const {
  const SurfaceMaterial& material = surface.material;
  const auto [lit_mixed, lit_real] = illuminate(
      phong_of(surface.base_color(), material.metallic, material.roughness), branch, surface, to);
  Color m = material.emission + lit_mixed, r = material.emission + lit_real;
  if (branch.depth > 0) {
    const Phong phong = phong_of(surface.base_color(), material.metallic, material.roughness);
    m *= gain_within(refractive_index(branch.media.innermost()), phong);
    r *= gain_within(refractive_index(branch.media.innermost_real()), phong);
  }
  const Color& w = branch.weight;
  if (surface.object.role == scene::Role::Virtual) {
    to.sample.mixed += w * m;
    return;
  }
  LookUp seen;
  // A primary ray's point is under the camera's pixel itself: the composite adds that.
  if (in_.camera_view != nullptr && branch.depth > 0) {
    seen = look_up(in_.world, *in_.camera_view, surface.hit.position, surface.geometric_normal);
    to.decisions.note(seen.trust > 0.0 ? 5 : 4);
  }
  const double f = seen.trust;
  const Color& l = seen.radiance;
  if (f > 0.0) {
    to.sample.mixed +=
        w * f * changed_radiance(l, m, r, in_.camera_view->response, in_.settings.ratio);
  }
  to.sample.mixed += w * (1.0 - f) * m;
  to.sample.real += w * (f * l + (1.0 - f) * r);
}

Whitted::Shaded Whitted::illuminate(const Phong& phong, const Branch& branch,
                                    const Surface& surface, Collector& to) const {
  Shaded result{Color(0.0), Color(0.0)};
  for (const scene::Light& light : in_.lights) {
    const ArrivingLight arrival = arriving_light(light, surface.hit.position);
    if (!(glm::dot(surface.shading_normal, arrival.to_light) > 0.0)) continue;
    const Color reflected_light =
        arrival.irradiance *
        reflected(phong, surface.shading_normal, arrival.to_light, surface.to_viewer);
    // A light that grazes the surface changes nothing, however it is decided whether it arrives.
    Decisions unheeded;
    const bool matters = largest_channel(branch.weight * reflected_light) > kNegligible;
    Decisions& decisions = matters ? to.decisions : unheeded;
    const bool above = glm::dot(surface.geometric_normal, arrival.to_light) > 0.0;
    decisions.note(above ? 7 : 6);
    if (!above) continue;
    const Shadow shadow = cast_shadow_ray(in_.world, surface.hit.position, arrival, decisions);
    result.mixed += shadow.mixed * reflected_light;
    result.real += shadow.real * reflected_light;
  }
  return result;
}

Vec3 Whitted::mirror_normal(const Surface& surface) {
  return bend_normal(surface.shading_normal, surface.geometric_normal, surface.to_viewer);
}

void Whitted::meet_mirror(const Branch& branch, const Surface& surface, Collector& to) const {
  const Vec3 normal = mirror_normal(surface);
  const double cosine = std::min(1.0, glm::dot(normal, surface.to_viewer));
  const Vec3 direction = reflect(branch.ray.direction, normal);
  spawn(child_of(branch, surface, direction, schlick(surface.base_color(), cosine)), to);
}

Whitted::Branch Whitted::child_of(const Branch& parent, const Surface& surface,
                                  const Vec3& direction, const Color& share) const {
  Ray ray = ray_from_surface(surface.hit.position, direction);
  ray.width = parent.ray.width_at(surface.hit.t);
  ray.spread = parent.ray.spread;
  const double side = glm::dot(direction, surface.geometric_normal) < 0.0 ? -1.0 : 1.0;
  const Vec3 lift =
      side * in_.settings.lift * surface.object.coordinate_size * surface.geometric_normal;
  return {ray, parent.weight * share, parent.depth + 1, parent.media, lift};
}

}  // namespace amalgam::reference
