#include "scene/marker_ids.h"

#include <set>

namespace amalgam::scene {

std::vector<int> marker_ids(const Scene& scene) {
  std::set<int> bound;
  for (const Instance& instance : scene.instances) {
    if (instance.marker && *instance.marker != scene.world.marker) bound.insert(*instance.marker);
  }
  std::vector<int> ids{scene.world.marker};
  ids.insert(ids.end(), bound.begin(), bound.end());
  return ids;
}

}  // namespace amalgam::scene
