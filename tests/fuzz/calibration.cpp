// A calibration file: refused with one line, or a camera that can be rendered with.
#include "client/tracking/calibration.h"

#include <stdexcept>

#include "common/log.h"
#include "fuzz/scratch_file.h"
#include "fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amalgam;
  static const fuzz::ScratchFile file("calibration.yaml");
  try {
    const common::CameraModel camera =
        client::load_calibration(file.write(fuzz::as_text(data, size)));
    const bool has_size = camera.width != 0 || camera.height != 0;
    const std::string defect =
        common::describe_defect(has_size ? camera : client::fit_to_image(camera, 640, 480));
    AMALGAM_CHECK(defect.empty(), defect);
  } catch (const std::runtime_error&) {
  }
  return 0;
}
