#include "support/reference/whitted.h"

#include "support/reference/arriving_light.h"
#include "support/reference/bent_normal.h"
#include "support/reference/phong.h"
#include "support/reference/pictures.h"
#include "support/reference/shadow.h"

namespace amalgam::reference {

Sample Whitted::trace(const Ray& primary, Decisions& decisions) const {
  Sample sample;
  Collector to{sample, decisions};
  follow({.ray = primary}, to);
  return sample;
}

void Whitted::follow(const Branch& branch, Collector& to) const {
  const auto hit = in_.world.closest(branch.ray);
  to.decisions.note(hit ? 2 * hit->object + (is_front(branch.ray, *hit) ? 3 : 2) : 0);
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
  Surface surface{*hit,
                  object,
                  side * hit->geometric_normal,
                  side * hit->shading_normal,
                  -branch.ray.direction,
                  Color(in_.world.base_color(*hit))};
  if (object.role == scene::Role::Virtual) to.sample.met_virtual = true;
  if (object.material.kind == scene::MaterialKind::Diffuse) {
    add_diffuse(arrived, surface, to);
    return;
  }

  if (branch.depth == 0) to.sample.specular_first = true;
  const Color glow = arrived.weight * Color(object.material.emission);
  to.sample.mixed += glow;
  if (object.role == scene::Role::Real) to.sample.real += glow;
  surface.shading_normal =
      bend_normal(surface.shading_normal, surface.geometric_normal, surface.to_viewer);
  if (object.material.kind == scene::MaterialKind::Mirror) {
    meet_mirror(arrived, surface, to);
  } else if (object.material.thin) {
    meet_thin_glass(arrived, surface, to);
  } else {
    meet_glass(arrived, surface, to);
  }
}

void Whitted::spawn(const Branch& child, Collector& to) const {
  const double importance = largest_channel(child.weight);
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
  const Color light = branch.weight * environment_towards(*in_.environment, branch.ray.direction);
  if (in_.environment->low_dynamic_range) {
    to.sample.environment_reflection += light;  // must not be tone-mapped (section 4.4)
  } else {
    to.sample.mixed += light;
    to.sample.real += light;
  }
}

void Whitted::add_diffuse(const Branch& branch, const Surface& surface, Collector& to) const {
  const auto [m, r] = shade(surface, to);
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
  to.sample.mixed += w * (f * glm::max(l + (m - r), Color(0.0)) + (1.0 - f) * m);
  to.sample.real += w * (f * l + (1.0 - f) * r);
}

Whitted::Shaded Whitted::shade(const Surface& surface, Collector& to) const {
  const scene::Material& material = surface.object.material;
  const Phong phong = phong_of(material, surface.base_color);
  Shaded result{Color(material.emission), Color(material.emission)};
  for (const scene::Light& light : in_.lights) {
    const ArrivingLight arrival = arriving_light(light, surface.hit.position);
    if (!(glm::dot(surface.shading_normal, arrival.to_light) > 0.0)) continue;
    const bool above = glm::dot(surface.geometric_normal, arrival.to_light) > 0.0;
    to.decisions.note(above ? 7 : 6);
    if (!above) continue;
    const Color reflected_light =
        arrival.irradiance *
        reflected(phong, surface.shading_normal, arrival.to_light, surface.to_viewer);
    const Shadow shadow = cast_shadow_ray(in_.world, surface.hit.position, arrival, to.decisions);
    result.mixed += shadow.mixed * reflected_light;
    result.real += shadow.real * reflected_light;
  }
  return result;
}

void Whitted::meet_mirror(const Branch& branch, const Surface& surface, Collector& to) const {
  const double cosine = std::min(1.0, glm::dot(surface.shading_normal, surface.to_viewer));
  const Vec3 direction = reflect(branch.ray.direction, surface.shading_normal);
  spawn(child_of(branch, surface, direction, schlick(surface.base_color, cosine)), to);
}

void Whitted::meet_thin_glass(const Branch& branch, const Surface& surface, Collector& to) const {
  const double cosine = std::min(1.0, glm::dot(surface.shading_normal, surface.to_viewer));
  const double ior = static_cast<double>(surface.object.material.ior);
  const double k_s = thin_reflectance(reflectance(in_.settings.fresnel, 1.0, ior, cosine));
  const Vec3 reflected_direction = reflect(branch.ray.direction, surface.shading_normal);
  spawn(child_of(branch, surface, reflected_direction, Color(k_s)), to);
  spawn(child_of(branch, surface, branch.ray.direction, (1.0 - k_s) * surface.base_color), to);
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

  const double cosine = std::min(1.0, glm::dot(surface.shading_normal, surface.to_viewer));
  const auto refracted_direction = refract(branch.ray.direction, surface.shading_normal, n1, n2);
  const double k_s = refracted_direction ? reflectance(in_.settings.fresnel, n1, n2, cosine) : 1.0;
  const Vec3 reflected_direction = reflect(branch.ray.direction, surface.shading_normal);
  spawn(child_of(branch, surface, reflected_direction, Color(k_s)), to);
  if (!refracted_direction) return;
  Branch refracted =
      child_of(branch, surface, *refracted_direction, (1.0 - k_s) * surface.base_color);
  refracted.media = beyond;
  spawn(refracted, to);
}

Whitted::Branch Whitted::child_of(const Branch& parent, const Surface& surface,
                                  const Vec3& direction, const Color& share) {
  return {ray_from_surface(surface.hit.position, direction), parent.weight * share,
          parent.depth + 1, parent.media};
}

}  // namespace amalgam::reference
