#include "client/tools/marker/scene_markers.h"

#include "client/tracking/marker_dictionary.h"
#include "scene/marker_ids.h"

namespace amalgam::tools {

SheetOptions markers_of(const scene::Scene& scene) {
  SheetOptions options;
  options.dictionary = client::predefined_dictionary(scene.world.dictionary);
  options.length = scene.world.marker_length;
  options.ids = scene::marker_ids(scene);
  return options;
}

}  // namespace amalgam::tools
