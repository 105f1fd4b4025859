// Converts a client's picture of its surroundings to the environment that lights the scene.
#pragma once

#include <cstdint>

#include "common/image.h"
#include "frame/frame.h"
#include "scene/light/environment.h"

namespace amalgam::frame {

// Decodes the picture and, for a fish-eye, unrolls it. Throws codec::JpegError or
// std::invalid_argument with one line.
scene::Environment make_environment(const EnvironmentInput& input);

// Bytes that the picture and its environment take together, by the picture's header; 0 if that is
// unusable.
std::uint64_t environment_bytes(const EnvironmentInput& input);

// An equirectangular low-dynamic-range map of what the fish-eye sees (the thesis's camera).
// Directions outside its view get the mean color of those inside, by solid angle: neither a dark
// nor a bright hole.
scene::Environment unroll_fisheye(const common::ImageRgb8& picture,
                                  const common::FisheyeModel& fisheye,
                                  const glm::dquat& world_from_fisheye);

}  // namespace amalgam::frame
