// Finds a set of marker patterns by name.
#pragma once

#include <opencv2/aruco/dictionary.hpp>
#include <string>

namespace amalgam::tracking {

// A predefined dictionary of OpenCV ("DICT_6X6_250", "DICT_APRILTAG_36h11", ...), or the path of a
// dictionary file (.yml, .yaml: nmarkers, markersize, marker_0, ...). Throws std::runtime_error for
// anything else; for an unknown name it lists the known ones.
cv::Ptr<cv::aruco::Dictionary> find_dictionary(const std::string& name);

// The name of a predefined dictionary as it is; throws as above for any other. For names that come
// from a server or a scene: whoever wrote them must not choose which files are read here.
const std::string& predefined_dictionary(const std::string& name);

}  // namespace amalgam::tracking
