#include "frame/view_state.h"

#include <stdexcept>

namespace amalgam::frame {

void check_view(const ViewOptions& options) {
  if (const std::string defect = common::describe_defect(options.camera); !defect.empty()) {
    throw std::invalid_argument(defect);
  }
  if (options.jpeg_quality < 0 || options.jpeg_quality > 100) {
    throw std::invalid_argument("JPEG quality must be within 1 and 100, or 0 for the default");
  }
}

ViewState::ViewState(const ViewOptions& view_options) : options(view_options) {
  check_view(options);
  ideal = common::ideal_camera_covering(options.camera);
  if (options.camera.has_distortion()) warp_map = passes::make_warp_map(options.camera, ideal);
}

}  // namespace amalgam::frame
