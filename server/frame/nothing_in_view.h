// Whether a frame can be sent back before anything is drawn: nothing virtual, and no shadow of it,
// reaches what the camera sees.
#pragma once

#include <span>

#include "passes/frame_resources.h"
#include "scene/bounds.h"
#include "scene/scene.h"

namespace amalgam::frame {

// True only if it is certain. Every virtual object's box lies beside the view or behind the camera,
// and so does what it could shade: for each light, the box drawn out away from the light until
// behind all real objects. A real mirror or glass in view may show what is not in view, so then
// nothing is certain. mesh_bounds: by Scene::meshes.
bool nothing_virtual_in_view(const scene::Scene& scene, std::span<const scene::Bounds> mesh_bounds,
                             const passes::RenderView& view);

}  // namespace amalgam::frame
