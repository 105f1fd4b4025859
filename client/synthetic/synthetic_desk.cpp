#include "client/synthetic/synthetic_desk.h"

#include <opencv2/core.hpp>
#include <stdexcept>

#include "client/synthetic/desk_picture.h"
#include "tracking/marker_dictionary.h"

namespace amalgam::client {
namespace {

// 1.6 mm for the whole desk and 0.4 mm near the sheet: a pixel there covers half a millimetre.
constexpr double kDeskSide = 2.4;  // metres
constexpr int kDeskTexels = 1500;
constexpr double kNearSide = 0.64;
constexpr int kNearTexels = 1600;

constexpr PackedColor kInk = 0x1A1818;
constexpr PackedColor kPaper = 0xE8ECEC;

}  // namespace

SyntheticDesk::SyntheticDesk(const PrintedMarker& marker, std::optional<DeskMirror> mirror)
    : marker_(marker),
      mirror_(mirror),
      whole_({-kDeskSide / 2, -kDeskSide * 0.4}, kDeskSide, kDeskTexels, desk_picture),
      near_({-kNearSide / 2, -kNearSide * 0.35}, kNearSide, kNearTexels, desk_picture) {
  const auto dictionary = tracking::find_dictionary(marker.dictionary);
  if (marker.id < 0 || marker.id >= dictionary->bytesList.rows) {
    throw std::runtime_error("marker " + std::to_string(marker.id) + " is not in " +
                             marker.dictionary);
  }
  cells_ = dictionary->markerSize + 2;
  const double margin = marker.length / cells_;
  const double room = 2.0 * (std::min(kSheetHalfWidth, kSheetTop) - margin);
  if (!(marker.length > 0) || marker.length > room) {
    throw std::runtime_error("a marker of that length does not fit on the synthetic sheet");
  }
  cells_per_metre_ = cells_ / marker.length;
  const cv::Mat inner = cv::aruco::Dictionary::getBitsFromByteList(
      dictionary->bytesList.row(marker.id), dictionary->markerSize);
  bits_.assign(static_cast<std::size_t>(cells_ * cells_), 0);
  for (int y = 0; y < inner.rows; ++y) {
    for (int x = 0; x < inner.cols; ++x) {
      bits_[static_cast<std::size_t>((y + 1) * cells_ + x + 1)] = inner.at<unsigned char>(y, x);
    }
  }
}

PackedColor SyntheticDesk::color(const glm::dvec2& point, double footprint) const {
  // The marker is evaluated and not looked up: its edges are where poses come from.
  const double column = point.x * cells_per_metre_ + 0.5 * cells_;
  const double row = 0.5 * cells_ - point.y * cells_per_metre_;
  if (column >= 0 && row >= 0 && column < cells_ && row < cells_) {
    const int cell = static_cast<int>(row) * cells_ + static_cast<int>(column);
    return bits_[static_cast<std::size_t>(cell)] != 0 ? kPaper : kInk;
  }
  return (near_.covers(point) ? near_ : whole_).sample(point, footprint);
}

}  // namespace amalgam::client
