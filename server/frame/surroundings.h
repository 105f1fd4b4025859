// An environment, and what is computed of it once for all frames that it lights. The scene's belong
// to all views; a view may have its own instead.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "passes/image/light_extraction.h"
#include "scene/light/environment.h"

namespace amalgam::frame {

struct Surroundings {
  // serial: another one for each of a renderer, so that results kept for one are not taken for
  // another.
  Surroundings(std::optional<scene::Environment> light, std::uint64_t serial)
      : environment(std::move(light)),
        largest(environment ? scene::largest_radiance(*environment) : glm::vec3(0.0f)),
        number(serial) {}

  const scene::Environment* map() const { return environment ? &*environment : nullptr; }

  const std::optional<scene::Environment> environment;  // none: black
  const glm::vec3 largest;                              // scene::largest_radiance; 0 without one
  const std::uint64_t number;
  passes::EnvironmentLightCache lights;  // filled by the first frame
};

}  // namespace amalgam::frame
