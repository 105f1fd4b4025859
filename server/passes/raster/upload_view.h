// Uploads one frame's camera and the instances' matrices for the shaders.
//
// Projection (numerics B14): the intrinsics and the instance's transform are multiplied in double,
// and only the product, clip_from_mesh, is rounded to float. y points down in the camera and row 0
// of a GL image is at y = -1, so the image is upright in memory. Depth is reversed, with the far
// plane at infinity: depth = kNearPlane / z.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "gl/buffer.h"
#include "gl/shader_interface.h"
#include "graph/frame_graph.h"
#include "passes/frame_resources.h"
#include "passes/raster/raster_context.h"
#include "scene/material.h"
#include "scene/scene.h"

namespace amalgam::passes {

using gl::kNearPlane;

// clip_from_camera of an ideal (undistorted) camera; ndc_x = 2 (u + 0.5) / width - 1 for pixel u.
glm::dmat4 clip_from_camera(const common::CameraModel& ideal);

// One instance to be drawn. Its position in DeviceView::items is its index on the GPU.
struct DrawItem {
  std::uint32_t mesh = 0;
  std::uint32_t material = 0;
  scene::Role role = scene::Role::Virtual;
  scene::MaterialKind kind = scene::MaterialKind::Diffuse;
  bool detailed = false;  // has textures or vertex colors
  bool cut_out = false;   // has an alpha mask and an alpha that varies
};

struct DeviceView {
  std::vector<DrawItem> items;
  gl::Buffer surfaces;  // shader_interface.h: GpuSurface, one an item
  gl::Buffer frame;     // GpuFrame
};

struct UploadViewInputs {
  const RasterContext& raster;
  const RenderView& view;
};

struct UploadViewOutputs {
  graph::Handle<DeviceView> device_view;
};

UploadViewOutputs add_upload_view_pass(graph::FrameGraph& graph, const UploadViewInputs& in);

}  // namespace amalgam::passes
