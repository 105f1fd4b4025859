// Tests whether a frame can go back before anything is drawn: no virtual object and no shadow of
// one is in view.
#pragma once

#include <span>

#include "passes/frame_resources.h"
#include "scene/bounds.h"
#include "scene/scene.h"

namespace amalgam::frame {

// Conservative: true only if it is certain. Every virtual object's box must lie beside the view or
// behind the camera. So must its shadow volume: for each light, the box extruded away from the
// light until behind all real objects in view. False if a real mirror or glass is in view, since it
// may show objects that are not. mesh_bounds: by Scene::meshes.
bool nothing_virtual_in_view(const scene::Scene& scene, std::span<const scene::Bounds> mesh_bounds,
                             const passes::RenderView& view);

}  // namespace amalgam::frame
