#include "client/tools/marker/scene_markers.h"

#include <set>

namespace amalgam::tools {

SheetOptions markers_of(const scene::Scene& scene) {
  SheetOptions options;
  options.dictionary = scene.world.dictionary;
  options.length = scene.world.marker_length;
  options.ids = {scene.world.marker};
  std::set<int> others;
  for (const scene::Instance& instance : scene.instances) {
    if (instance.marker) others.insert(*instance.marker);
  }
  others.erase(scene.world.marker);
  options.ids.insert(options.ids.end(), others.begin(), others.end());
  return options;
}

}  // namespace amalgam::tools
