// A bare replay of a frame's rays: what Embree alone takes for them. It is the bound that the
// tracer is measured against. The bench's only user of Embree.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bench/ray_log.h"
#include "scene/anchored_scene.h"
#include "scene/scene.h"

namespace amalgam::bench {

enum class ReplayCall { OneByOne, PacketsOfEight };

// What a ray met. For rays that only ask whether there is a hit, both are 0 if there is.
struct ReplayAnswer {
  static constexpr std::uint32_t kNothing = 0xffffffffu;
  std::uint32_t instance = kNothing;
  std::uint32_t triangle = kNothing;
  bool operator==(const ReplayAnswer&) const = default;
};

class Replay {
 public:
  // Builds the scene as trace/embree_scene does: two levels, robust, high quality. Throws
  // std::runtime_error.
  Replay(const scene::Scene& scene, const scene::AnchoredScene& anchored);
  ~Replay();

  // Chunks of 256 rays in parallel; a chunk's rays are sorted by what they ask and, for packets,
  // taken by eight as they come. answers: as many as rays.
  void run(std::span<const trace::LoggedRay> rays, ReplayCall call, int threads,
           std::span<ReplayAnswer> answers) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amalgam::bench
