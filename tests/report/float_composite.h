// The composite before it becomes bytes (core/layers.h), in display-linear light and as a display
// shows it, in [0, 1]. With Reinhard's curve.
#pragma once

#include "common/image.h"
#include "core/layers.h"
#include "frame/buffer_dump.h"
#include "support/reference/composite.h"

namespace amalgam::report {

// What is not finite stays so.
common::ImageRgb32f float_composite(const core::Layers& layers,
                                    const common::ImageRgb8& camera_image);
common::ImageRgb32f float_composite(const reference::Layers& layers,
                                    const common::ImageRgb8& camera_image);

// The layers of a rendered frame in the camera's size, from the buffers of the rendered image's.
// Empty layers if the frame had none. For cameras whose lens does not distort.
core::Layers frame_layers(const frame::FrameBuffers& buffers, glm::ivec2 camera_size,
                          float render_scale);

}  // namespace amalgam::report
