// From the picture that a client sends of its surroundings to the environment that lights the
// scene.
#pragma once

#include "common/image.h"
#include "frame/frame.h"
#include "scene/light/environment.h"

namespace amalgam::frame {

// Decodes and, for a fish-eye, unrolls the picture. Throws codec::JpegError or
// std::invalid_argument with one line.
scene::Environment make_environment(const EnvironmentInput& input);

// An equirectangular low-dynamic-range map of what the fish-eye sees (the thesis's camera).
// Directions that it does not see get the mean color of those that it does, by solid angle:
// neither a dark nor a bright hole.
scene::Environment unroll_fisheye(const common::ImageRgb8& picture,
                                  const common::FisheyeModel& fisheye,
                                  const glm::dquat& world_from_fisheye);

}  // namespace amalgam::frame
