#include "passes/raster/upload_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <span>
#include <utility>

#include "gl/shader_interface.h"

namespace amalgam::passes {
namespace {

// Transforms normals, for any affine transform (numerics B23): the cofactors, negated if the
// transform mirrors so that normals stay outward. Scaled to about 1, because products of millimetre
// scales would be too small for float.
glm::dmat4 normal_matrix(const glm::dmat3& linear) {
  const glm::dvec3 x = glm::cross(linear[1], linear[2]), y = glm::cross(linear[2], linear[0]),
                   z = glm::cross(linear[0], linear[1]);
  const double largest = std::max({glm::length(x), glm::length(y), glm::length(z)});
  const double sign = glm::dot(linear[0], x) < 0.0 ? -1.0 : 1.0;
  glm::dmat4 matrix(glm::dmat3(x, y, z) * (largest > 0.0 ? sign / largest : 1.0));
  matrix[3][3] = sign * largest;  // shader_interface.h: GpuSurface
  return matrix;
}

std::uint32_t mask_flags(const gl::GpuInstanceInfo& info) {
  std::uint32_t flags = SampleMask::kSurface;
  if (info.role == scene::Role::Virtual) flags |= SampleMask::kVirtual;
  if (scene::is_specular(info.kind)) flags |= SampleMask::kSpecular;
  return flags;
}

DeviceView upload(const RasterContext& raster, const RenderView& view) {
  const glm::dmat4 clip_from_world = clip_from_camera(view.ideal) * view.scene.camera_from_world;
  std::vector<DrawItem> items;
  std::vector<gl::GpuSurface> surfaces;
  for (const scene::AnchoredInstance& anchored : view.scene.instances) {
    const gl::GpuInstanceInfo& info = raster.scene.instances()[anchored.instance];
    if (info.invisible) continue;
    items.push_back({info.mesh, info.material, info.role, info.kind, info.detailed, info.cut_out});
    const glm::dmat4 world_from_mesh(anchored.world_from_mesh);
    gl::GpuSurface surface;
    surface.clip_from_mesh = glm::mat4(clip_from_world * world_from_mesh);
    surface.world_from_mesh = anchored.world_from_mesh;
    surface.normal_from_mesh = glm::mat4(normal_matrix(glm::dmat3(world_from_mesh)));
    surface.material = raster.scene.materials()[info.material];
    surface.material.textures = info.textures;
    surface.flags = mask_flags(info);
    surfaces.push_back(surface);
  }
  gl::GpuFrame frame;
  frame.eye_in_world = glm::vec3(common::rigid_inverse(view.scene.camera_from_world)[3]);
  frame.sample_spread = static_cast<float>(1.0 / (view.ideal.fy * view.samples_per_side));
  return {.items = std::move(items),
          .surfaces = gl::Buffer::of(std::span<const gl::GpuSurface>(surfaces)),
          .frame = gl::Buffer::of(std::span<const gl::GpuFrame>(&frame, 1))};
}

}  // namespace

glm::dmat4 clip_from_camera(const common::CameraModel& ideal) {
  // Rows: x_clip = 2 fx / W x + (2 (cx + 1/2) / W - 1) z, y_clip likewise, z_clip = near, w = z.
  const double width = ideal.width, height = ideal.height;
  glm::dmat4 clip(0.0);
  clip[0][0] = 2.0 * ideal.fx / width;
  clip[2][0] = 2.0 * (ideal.cx + 0.5) / width - 1.0;
  clip[1][1] = 2.0 * ideal.fy / height;
  clip[2][1] = 2.0 * (ideal.cy + 0.5) / height - 1.0;
  clip[3][2] = kNearPlane;
  clip[2][3] = 1.0;
  return clip;
}

UploadViewOutputs add_upload_view_pass(graph::FrameGraph& graph, const UploadViewInputs& in) {
  graph::Builder builder = graph.add_pass("upload view");
  const UploadViewOutputs out{.device_view = builder.writes<DeviceView>("device view")};
  builder.runs([in, out](const graph::Access& access) {
    in.raster.context.check_thread();
    access.set(out.device_view, upload(in.raster, in.view));
  });
  return out;
}

}  // namespace amalgam::passes
