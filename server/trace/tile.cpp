#include "trace/tile.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "core/pose.h"
#include "trace/hit_on_line.h"
#include "trace/shade.h"
#include "trace/shadow.h"

namespace amalgam::trace {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kBatchSize = 1024;

float mean(const glm::vec3& weight) {
  return (weight.x + weight.y + weight.z) / 3.0f;
}

float importance(const glm::vec3& weight) {
  return std::max({weight.x, weight.y, weight.z});
}

// Angle between neighbouring samples at the image's centre, radians: how a ray's cone widens.
double sample_spread(const TraceRequest& request) {
  return 1.0 / (request.camera.fy * request.samples_per_side);
}

}  // namespace

Tile::Tile(const TraceRequest& request, const CameraLookup* lookup, const Media& camera_media,
           int x, int y)
    : request_(request), lookup_(lookup), camera_media_(camera_media), x_(x), y_(y) {}

void Tile::trace() {
  generate_primary_rays();
  while (!waiting_.empty()) {
    take_batch();
    intersect_rays();
    shade_hits();
    add_escaped();
    spawn_shadow_rays();
    trace_shadow_rays();
    add_diffuse();
  }
}

void Tile::generate_primary_rays() {
  const int n = request_.samples_per_side;
  const glm::dmat4 world_from_camera = core::rigid_inverse(request_.camera_from_world);
  const glm::dmat3 rotation(world_from_camera);
  const glm::dvec3 eye(world_from_camera[3]);
  const int right = std::min(x_ + core::kTileSide, request_.camera.width);
  const int bottom = std::min(y_ + core::kTileSide, request_.camera.height);
  for (int y = y_; y < bottom; ++y) {
    for (int x = x_; x < right; ++x) {
      bool first = true;
      for (int s = 0; s < n * n; ++s) {
        const int i = s % n, j = s / n;
        if (request_.mask != nullptr &&
            (request_.mask->at(x * n + i, y * n + j) & request_.mask_bit) == 0) {
          continue;
        }
        const glm::dvec2 pixel(x - 0.5 + (i + 0.5) / n, y - 0.5 + (j + 0.5) / n);
        // From the intrinsics in double (numerics B14); a pinhole sees something through every
        // pixel.
        const glm::dvec3 direction(
            glm::normalize(rotation * *core::pixel_direction(request_.camera, pixel)));
        RayItem item;
        item.start = eye;
        item.direction = direction;
        item.ray = {glm::vec3(eye), glm::vec3(direction), kInfinity};
        item.media = camera_media_;
        item.sample = static_cast<std::uint32_t>(samples_.size());
        waiting_.push_back(item);
        samples_.emplace_back();
        places_.push_back({x, y, first});
        sees_real_diffuse_.push_back(false);
        first = false;
      }
    }
  }
  counts_.samples = samples_.size();
  std::reverse(waiting_.begin(), waiting_.end());
}

void Tile::take_batch() {
  const std::size_t count = std::min(waiting_.size(), kBatchSize);
  batch_.assign(waiting_.rbegin(), waiting_.rbegin() + static_cast<std::ptrdiff_t>(count));
  waiting_.resize(waiting_.size() - count);
  escaped_.clear();
  diffuse_.clear();
  shadows_.clear();
}

void Tile::intersect_rays() {
  hits_.clear();
  for (const RayItem& item : batch_) {
    switch (item.kind) {
      case RayKind::Primary:
        ++counts_.rays.primary;
        break;
      case RayKind::Reflection:
        ++counts_.rays.reflection;
        break;
      case RayKind::Refraction:
        ++counts_.rays.refraction;
        break;
    }
    hits_.push_back(request_.scene.intersect(item.ray, Visible::Everything));
    if (hits_.back()) {
      hits_.back()->t += glm::distance(item.start, glm::dvec3(item.ray.origin));
      hits_.back() = hit_on_line(request_.scene, *hits_.back(), item.start, item.direction,
                                 Visible::Everything);
    }
  }
}

// Section 3 of the method: what each hit does.
void Tile::shade_hits() {
  for (std::size_t i = 0; i < batch_.size(); ++i) {
    const RayItem& item = batch_[i];
    if (!hits_[i]) {
      // Seen directly, nothing is there to draw: the camera image stays.
      if (item.kind != RayKind::Primary)
        escaped_.push_back(
            {core::LightSource::Environment, glm::vec3(item.direction), item.weight, item.sample});
      continue;
    }
    const double cone_width = sample_spread(request_) * (item.path_length + hits_[i]->t);
    const SurfacePoint point = surface_point(request_.scene, *hits_[i], item.direction, cone_width);
    const scene::Material& material = request_.scene.scene().materials[point.material];
    if (material.alpha_cutoff && point.base_color.w < *material.alpha_cutoff) {
      pass_straight(item, point);
      continue;
    }
    glm::vec3 weight = item.weight;
    if (const auto medium = item.media.innermost()) {  // Beer-Lambert on the way here
      weight *= glm::exp(-request_.scene.scene().materials[*medium].absorption *
                         static_cast<float>(hits_[i]->t));
    }
    if (item.kind == RayKind::Primary) count_primary(point, material);
    if (point.role == scene::Role::Virtual) samples_[item.sample].met_virtual = true;
    if (scene::is_specular(material.kind)) {
      scatter(item, point, weight);
    } else {
      const bool primary = item.kind == RayKind::Primary;
      if (primary) sees_real_diffuse_[item.sample] = point.role == scene::Role::Real;
      // Seen directly it is as the rasteriser draws it, which knows no media.
      const glm::vec3& arriving = primary ? item.weight : weight;
      diffuse_.push_back({point, -glm::vec3(item.direction), arriving, item.sample,
                          primary ? RealColor::UnderPixel : RealColor::LookedUp});
    }
  }
}

void Tile::count_primary(const SurfacePoint& point, const scene::Material& material) {
  if (point.role == scene::Role::Virtual) ++counts_.primary_virtual;
  if (scene::is_specular(material.kind)) ++counts_.primary_specular;
}

// Mirror and glass: the reflected and the refracted child (eq. 4.7, 4.8).
void Tile::scatter(const RayItem& item, const SurfacePoint& point, const glm::vec3& weight) {
  const scene::Material& material = request_.scene.scene().materials[point.material];
  const glm::dvec3 normal =
      valid_shading_normal(point.geometric_normal, point.shading_normal, -item.direction);
  const double cos_incident = std::clamp(-glm::dot(item.direction, normal), 0.0, 1.0);
  const glm::dvec3 reflected = glm::normalize(reflect(item.direction, normal));
  const glm::vec3 glow = weight * point.emission;
  samples_[item.sample].mixed += glow;
  if (point.role == scene::Role::Real) samples_[item.sample].real += glow;
  if (material.kind == scene::MaterialKind::Mirror) {
    const glm::vec3 k_s =
        reflectance_conductor(glm::vec3(point.base_color), static_cast<float>(cos_incident));
    spawn(item, point, reflected, weight * k_s, RayKind::Reflection, item.media);
    return;
  }
  const glm::vec3 tint = point.transmission * glm::vec3(point.base_color);
  // What a rough surface does not let through has no mirror image: Phong's highlight stands for it.
  const float mirror_share = is_rough(point) ? point.transmission : 1.0f;
  const auto scattered = [&](float k_s) { return is_rough(point) ? 1.0f : 1.0f - k_s; };
  if (material.thin) {
    const double ior = material.ior;
    const auto k_s = static_cast<float>(
        thin_sheet_reflectance(reflectance(request_.settings.fresnel, cos_incident, 1.0, ior)));
    spawn(item, point, reflected, weight * k_s * mirror_share, RayKind::Reflection, item.media);
    spawn(item, point, item.direction, weight * tint * (1.0f - k_s), RayKind::Refraction,
          item.media);
    scatter_back(item, point, weight * scattered(k_s));
    return;
  }
  const auto& materials = request_.scene.scene().materials;
  const auto ior_of = [&](const Media& media) {
    const auto medium = media.innermost();
    return medium ? double{materials[*medium].ior} : 1.0;
  };
  const Media beyond =
      point.front ? item.media.entered(point.material) : item.media.left(point.material);
  // A ray that meets the inner side without having entered (an open mesh) comes out of the glass
  // all the same.
  const double eta_here =
      !point.front && !item.media.innermost() ? material.ior : ior_of(item.media);
  const double eta_beyond = ior_of(beyond);
  const auto refracted = refract(item.direction, normal, eta_here, eta_beyond);
  const auto k_s = refracted ? static_cast<float>(reflectance(request_.settings.fresnel,
                                                              cos_incident, eta_here, eta_beyond))
                             : 1.0f;
  spawn(item, point, reflected, weight * k_s * mirror_share, RayKind::Reflection, item.media);
  if (refracted) {
    spawn(item, point, *refracted, weight * tint * (1.0f - k_s), RayKind::Refraction, beyond);
  }
  scatter_back(item, point, weight * scattered(k_s));
}

// What glass neither reflects nor lets through (its transmission texture) its surface scatters. It
// is shaded as modelled and never looked up: the camera sees all of the surface there and not this
// share of it.
void Tile::scatter_back(const RayItem& item, const SurfacePoint& point, const glm::vec3& weight) {
  const glm::vec3 scattered = (1.0f - point.transmission) * weight;
  if (!(importance(scattered) > 0.0f)) return;
  diffuse_.push_back(
      {point, -glm::vec3(item.direction), scattered, item.sample, RealColor::Modelled});
}

// Masked-out texels are not there. No surface was met, so the line goes on from where it started,
// with its depth and weight; each step moves on along it, so this ends.
void Tile::pass_straight(const RayItem& item, const SurfacePoint& point) {
  RayItem next = item;
  next.ray.origin = point.ray_origin(item.direction);
  waiting_.push_back(next);
}

// A child ray, or its end: beyond the depth limit or below the importance cut-off it takes the
// environment.
void Tile::spawn(const RayItem& parent, const SurfacePoint& point, const glm::dvec3& direction,
                 const glm::vec3& weight, RayKind kind, const Media& media) {
  if (!(importance(weight) > 0.0f)) return;
  const bool deep = parent.depth + 1 > request_.settings.max_depth;
  if (deep || importance(weight) < request_.settings.importance_cutoff) {
    escaped_.push_back({core::LightSource::CutOff, glm::vec3(direction), weight, parent.sample});
    return;
  }
  RayItem child;
  child.start = point.position;
  child.direction = direction;
  child.ray = {point.ray_origin(direction), glm::vec3(direction), kInfinity};
  child.weight = weight;
  child.media = media;
  child.path_length = parent.path_length + glm::distance(point.position, parent.start);
  child.sample = parent.sample;
  child.depth = static_cast<std::uint16_t>(parent.depth + 1);
  child.kind = kind;
  waiting_.push_back(child);
}

void Tile::add_escaped() {
  for (const EscapedItem& item : escaped_) {
    add_share(samples_[item.sample].provenance, item.source, mean(item.weight));
    if (request_.environment == nullptr) continue;
    const glm::vec3 light =
        item.weight * scene::sample_environment(*request_.environment, item.direction);
    SampleResult& sample = samples_[item.sample];
    if (request_.environment->low_dynamic_range) {
      sample.environment_reflection += light;
    } else {
      sample.mixed += light;
      sample.real += light;
    }
  }
}

void Tile::spawn_shadow_rays() {
  radiance_.assign(diffuse_.size(), {});
  for (std::uint32_t d = 0; d < diffuse_.size(); ++d) {
    const DiffuseItem& item = diffuse_[d];
    const scene::Material& material = request_.scene.scene().materials[item.point.material];
    const scene::PhongTerms terms = phong_terms_at(item.point, material.kind);
    // What glows of glass was added where the ray met it.
    if (!scene::is_specular(material.kind))
      radiance_[d] = {item.point.emission, item.point.emission};
    for (const scene::Light& light : request_.lights) {
      const scene::LightArrival arrival =
          scene::light_arrival(light, glm::vec3(item.point.position));
      const glm::vec3 contribution = phong_contribution(terms, item.point, item.view, arrival);
      if (contribution == glm::vec3(0.0f)) continue;
      const glm::vec3 origin = item.point.ray_origin_on_line(glm::dvec3(arrival.to_light));
      shadows_.push_back(
          {item.point.position, {origin, arrival.to_light, arrival.distance}, contribution, d});
    }
  }
}

void Tile::trace_shadow_rays() {
  counts_.rays.shadow += shadows_.size();
  for (const ShadowItem& item : shadows_) {
    const ShadowAttenuation attenuation = trace_shadow(request_.scene, item.start, item.ray);
    radiance_[item.diffuse].mixed += item.contribution * attenuation.mixed;
    radiance_[item.diffuse].real += item.contribution * attenuation.real;
  }
}

void Tile::add_diffuse() {
  for (std::size_t d = 0; d < diffuse_.size(); ++d) {
    const DiffuseItem& item = diffuse_[d];
    if (item.point.role == scene::Role::Virtual) {
      SampleResult& sample = samples_[item.sample];
      sample.mixed += item.weight * radiance_[d].mixed;
      add_share(sample.provenance, core::LightSource::TracedVirtual, mean(item.weight));
    } else {
      add_real_surface(item, radiance_[d]);
    }
  }
}

// Differential rendering along the ray: the camera's own colour L where it can be had, changed by
// what virtual objects change. L + (m - r) in that order, so that m = r leaves L exactly.
void Tile::add_real_surface(const DiffuseItem& item, const DiffuseRadiance& radiance) {
  SampleResult& sample = samples_[item.sample];
  glm::vec3 mixed = radiance.mixed, real = radiance.real;
  float from_camera = item.real_color == RealColor::UnderPixel ? 1.0f : 0.0f;
  if (item.real_color == RealColor::LookedUp && lookup_ != nullptr) {
    if (const auto seen = lookup_->look_up(request_.scene, item.point, counts_.rays.lookup)) {
      const glm::vec3 changed =
          glm::max(seen->radiance + (radiance.mixed - radiance.real), glm::vec3(0.0f));
      from_camera = seen->trust;
      mixed = glm::mix(radiance.mixed, changed, seen->trust);
      real = glm::mix(radiance.real, seen->radiance, seen->trust);
    }
  }
  sample.mixed += item.weight * mixed;
  sample.real += item.weight * real;
  const float share = mean(item.weight);
  add_share(sample.provenance, core::LightSource::CameraLookup, share * from_camera);
  add_share(sample.provenance, core::LightSource::ModelledReal, share * (1.0f - from_camera));
}

}  // namespace amalgam::trace
