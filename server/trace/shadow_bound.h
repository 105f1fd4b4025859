// A cheap conservative test before a shadow ray: can a virtual object occlude the light at all?
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

namespace amalgam::trace {

class ShadowBound {
 public:
  virtual ~ShadowBound() = default;

  // False only where nothing virtual lies between the point (world, metres) and the light. light:
  // index into TraceRequest::lights.
  virtual bool may_be_shaded(std::size_t light, const glm::vec3& point) const = 0;
};

}  // namespace amalgam::trace
