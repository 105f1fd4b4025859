#include "client/tools/marker/scene_markers.h"

#include "scene/marker_ids.h"
#include "tracking/marker_dictionary.h"

namespace amalgam::tools {

sheet::SheetOptions markers_of(const scene::Scene& scene) {
  sheet::SheetOptions options;
  options.dictionary = tracking::predefined_dictionary(scene.world.dictionary);
  options.length = scene.world.marker_length;
  options.ids = scene::marker_ids(scene);
  return options;
}

}  // namespace amalgam::tools
