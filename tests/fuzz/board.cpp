// A board's layout file, or the short form of a regular board: refused with one line, or a board
// without a defect.
#include "client/tracking/board_description.h"

#include <stdexcept>

#include "common/log.h"
#include "fuzz/scratch_file.h"
#include "fuzz/target.h"

namespace amalgam::fuzz {
namespace {

template <typename Read>
void check_board(Read read) {
  try {
    const std::string defect = tracking::describe_defect(read());
    AMALGAM_CHECK(defect.empty(), defect);
  } catch (const std::runtime_error&) {
  }
}

}  // namespace
}  // namespace amalgam::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace amalgam;
  static const fuzz::ScratchFile file("board.yaml");
  const std::string text = fuzz::as_text(data, size);
  fuzz::check_board([&] { return client::load_board(file.write(text)); });
  constexpr std::size_t kLongestShortForm = 64;
  if (text.size() > kLongestShortForm) return 0;
  fuzz::check_board([&] { return client::parse_grid_board(text); });
  fuzz::check_board([&] { return client::parse_charuco_board(text); });
  return 0;
}
