// Custom properties that look like ours and that nothing reads: slips that a file's author cannot
// see, because foreign extras are nobody's business and are passed over.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/check/json_value.h"

namespace amalgam::scene {

// One line for each: flat ("amalgam_role", "role"), misspelt ("Amalgam", "rolle"), or in a place
// where ours are not read (meshes, materials, cameras). Or one line if nothing in the file has
// extras of ours at all.
std::vector<std::string> doubtful_extras(const JsonCursor& root);

}  // namespace amalgam::scene
