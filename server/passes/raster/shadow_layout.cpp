#include "passes/raster/shadow_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>
#include <string>

#include "passes/raster/upload_view.h"

namespace amalgam::passes {
namespace {

// Rows of a rotation whose z points to the light. Handedness and roll do not matter to shadows.
std::array<glm::dvec3, 3> basis_towards(const glm::dvec3& z) {
  const glm::dvec3 helper =
      std::abs(z.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 x = glm::normalize(glm::cross(helper, z));
  return {x, glm::cross(z, x), z};
}

void set_row(glm::dmat4& matrix, int row, const glm::dvec3& linear, double constant) {
  for (int column = 0; column < 3; ++column) matrix[column][row] = linear[column];
  matrix[3][row] = constant;
}

struct Layer {
  gl::GpuShadowLayer gpu;
  double texel = 0.0;       // ShadowLayout::texels
  double plane_step = 0.0;  // GpuLight::plane_step
};

struct Bounds {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  bool is_empty() const { return !(low.x <= high.x && low.y <= high.y); }
  void include(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
};

Bounds bounds_along(const std::array<glm::dvec3, 3>& axes, const glm::mat4& world_from_mesh,
                    const gl::GpuMesh& mesh) {
  Bounds bounds;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::vec3 in_mesh((corner & 1) != 0 ? mesh.high.x : mesh.low.x,
                            (corner & 2) != 0 ? mesh.high.y : mesh.low.y,
                            (corner & 4) != 0 ? mesh.high.z : mesh.low.z);
    const glm::dvec3 p(glm::dmat4(world_from_mesh) * glm::dvec4(in_mesh, 1.0));
    const glm::dvec3 along(glm::dot(axes[0], p), glm::dot(axes[1], p), glm::dot(axes[2], p));
    bounds.include({along, along});
  }
  return bounds;
}

// What a parallel layer must hold, along the light's axes. Across the light: where one instance may
// shadow another, or itself. A flat instance cannot shadow itself, so a wide table counts only
// where something else is above or below it. Along the light: everything.
Bounds bounds_of_shadows(const std::array<glm::dvec3, 3>& axes, const RenderView& view,
                         const gl::GpuScene& scene) {
  // The time to compare the flat ones grows with the square of their number.
  constexpr std::size_t kMostFlat = 32;
  Bounds all, shadows;
  std::vector<Bounds> flat;
  for (const scene::AnchoredInstance& anchored : view.scene.instances) {
    const gl::GpuMesh& mesh = scene.meshes()[scene.instances()[anchored.instance].mesh];
    const Bounds bounds = bounds_along(axes, anchored.world_from_mesh, mesh);
    all.include(bounds);
    if (!mesh.flat || flat.size() == kMostFlat) {
      shadows.include(bounds);
      continue;
    }
    for (const Bounds& other : flat) {
      const Bounds both{glm::max(bounds.low, other.low), glm::min(bounds.high, other.high)};
      if (!both.is_empty()) shadows.include(both);
    }
    flat.push_back(bounds);
  }
  if (all.is_empty()) all = {glm::dvec3(0.0), glm::dvec3(0.0)};
  if (shadows.is_empty()) shadows = all;
  shadows.low.z = all.low.z;
  shadows.high.z = all.high.z;
  return shadows;
}

Layer parallel_layer(const glm::vec3& to_light, const RenderView& view, const gl::GpuScene& scene,
                     int size) {
  const auto axes = basis_towards(glm::normalize(glm::dvec3(to_light)));
  Bounds bounds = bounds_of_shadows(axes, view, scene);
  // A margin: for the filter at the border, and because a flat scene has no depth.
  const glm::dvec3 extent = bounds.high - bounds.low;
  const double across =
      std::max({std::max(0.01, 3.0 / size) * std::max(extent.x, extent.y), 1e-5 * extent.z, 1e-5});
  const double along = 0.01 * std::max({extent.x, extent.y, extent.z, 1e-3});
  bounds.low -= glm::dvec3(across, across, along);
  bounds.high += glm::dvec3(across, across, along);

  // Texels are squares.
  const glm::dvec3 centre = 0.5 * (bounds.low + bounds.high);
  const double side = std::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
  const double depth = bounds.high.z - bounds.low.z;
  glm::dmat4 clip(1.0);
  for (int i = 0; i < 2; ++i) {
    set_row(clip, i, axes[static_cast<std::size_t>(i)] * (2.0 / side), -2.0 * centre[i] / side);
  }
  set_row(clip, 2, axes[2] / depth, -bounds.low.z / depth);
  gl::GpuShadowLayer layer;
  layer.clip_from_world = glm::mat4(clip);
  layer.eye = to_light;
  const double texel = side / size;
  // A row x has the length 2 / side.
  return {layer, texel, texel * (0.5 * side) / depth};
}

// Looks along axes[2] from the light.
Layer perspective_layer(const glm::dvec3& position, const std::array<glm::dvec3, 3>& axes,
                        double tangent, int size) {
  glm::dmat4 clip(0.0);
  for (int i = 0; i < 2; ++i) {
    const glm::dvec3 axis = axes[static_cast<std::size_t>(i)] / tangent;
    set_row(clip, i, axis, -glm::dot(axis, position));
  }
  clip[3][2] = kNearPlane;
  set_row(clip, 3, axes[2], -glm::dot(axes[2], position));
  gl::GpuShadowLayer layer;
  layer.clip_from_world = glm::mat4(clip);
  layer.eye = glm::vec3(position);
  layer.perspective = 1;
  // A row x has the length 1 / tangent.
  return {layer, 2.0 * tangent / size, kNearPlane * tangent * tangent * 2.0 / size};
}

// Adds a margin for the filter at the border.
double with_room(double tangent, int size) {
  return tangent * (1.0 + 4.0 / size);
}

// Sides in the order +x -x +y -y +z -z; a side's other two axes in cyclic order (shadow.glsl).
std::array<glm::dvec3, 3> cube_axes(int side) {
  const int forward = side / 2;
  std::array<glm::dvec3, 3> axes{};
  axes[0][(forward + 1) % 3] = 1.0;
  axes[1][(forward + 2) % 3] = 1.0;
  axes[2][forward] = side % 2 == 0 ? 1.0 : -1.0;
  return axes;
}

double spot_half_angle(const scene::Light& light) {
  return std::acos(std::clamp(static_cast<double>(light.cos_outer), -1.0, 1.0));
}

std::uint32_t layers_needed(const scene::Light& light) {
  using Kind = scene::Light::Kind;
  if (light.kind == Kind::Directional) return 1;
  return light.kind == Kind::Spot && spot_half_angle(light) <= kMaxSpotHalfAngle ? 1
                                                                                 : gl::kCubeSides;
}

gl::GpuLight describe(const scene::Light& light, std::size_t first_layer) {
  gl::GpuLight gpu;
  gpu.to_light = light.to_light;
  gpu.kind = static_cast<std::uint32_t>(light.kind);
  gpu.position = light.position;
  gpu.range = light.range;
  gpu.intensity = light.intensity;
  gpu.cos_inner = light.cos_inner;
  gpu.cos_outer = light.cos_outer;
  gpu.first_layer = static_cast<std::uint32_t>(first_layer);
  gpu.layer_count = layers_needed(light);
  return gpu;
}

int size_for(std::size_t layers) {
  if (layers <= 8) return 2048;
  if (layers <= 32) return 1024;
  return layers <= 128 ? 512 : 256;
}

}  // namespace

ShadowLayout make_shadow_layout(const RenderView& view, const gl::GpuScene& scene, int size) {
  if (view.lights.size() > gl::kMaxLights) {
    throw std::runtime_error(std::to_string(view.lights.size()) +
                             " lights, but rasterising takes " + std::to_string(gl::kMaxLights) +
                             " at most");
  }
  ShadowLayout layout;
  layout.lights = view.lights;
  layout.instances = view.scene.instances;
  layout.requested_size = size;
  std::size_t layers = 0;
  for (const scene::Light& light : view.lights) layers += layers_needed(light);
  layout.size = size > 0 ? size : size_for(layers);

  for (const scene::Light& light : view.lights) {
    gl::GpuLight& gpu = layout.gpu_lights.emplace_back(describe(light, layout.layers.size()));
    float& texel = layout.texels.emplace_back();
    const auto add = [&](const Layer& layer) {
      layout.layers.push_back(layer.gpu);
      texel = static_cast<float>(layer.texel);
      gpu.plane_step = static_cast<float>(layer.plane_step);
      gpu.clip_from_world = layer.gpu.clip_from_world;
    };
    if (light.kind == scene::Light::Kind::Directional) {
      add(parallel_layer(light.to_light, view, scene, layout.size));
      continue;
    }
    const glm::dvec3 position(light.position);
    if (gpu.layer_count == 1) {
      auto axes = basis_towards(glm::normalize(glm::dvec3(light.to_light)));
      axes[2] = -axes[2];
      const double tangent = with_room(std::tan(spot_half_angle(light)), layout.size);
      add(perspective_layer(position, axes, tangent, layout.size));
      continue;
    }
    const double tangent = with_room(1.0, layout.size);
    for (int side = 0; side < static_cast<int>(gl::kCubeSides); ++side) {
      add(perspective_layer(position, cube_axes(side), tangent, layout.size));
    }
    gpu.clip_from_world[0][0] = static_cast<float>(tangent);
  }
  return layout;
}

bool is_layout_of(const ShadowLayout& layout, const RenderView& view, int size) {
  return layout.requested_size == size && layout.lights == view.lights &&
         layout.instances == view.scene.instances;
}

}  // namespace amalgam::passes
