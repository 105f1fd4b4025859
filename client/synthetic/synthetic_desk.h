// The synthetic camera's subject: a wooden desk, a sheet of paper with a real ArUco marker, and
// flat colored things that are recognisable when glass turns them upside down. A mirror may stand
// on it.
//
// The desk is the plane z = 0 of OpenCV's marker frame: points are (x to the marker's right, y to
// its top) in metres.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "client/synthetic/desk_mirror.h"
#include "client/synthetic/desk_texture.h"

namespace amalgam::client {

struct PrintedMarker {
  std::string dictionary = "DICT_6X6_250";
  int id = 40;
  double length = 0.05;  // metres, side of the black square
};

class SyntheticDesk {
 public:
  // Throws std::runtime_error if the dictionary is unknown, has no such marker, or the marker would
  // not fit on the sheet with a margin.
  explicit SyntheticDesk(const PrintedMarker& marker, std::optional<DeskMirror> mirror = {});

  bool covers(const glm::dvec2& point) const { return whole_.covers(point); }

  // footprint: the sample's width on the desk, metres. The point must be covered.
  PackedColor color(const glm::dvec2& point, double footprint) const;

  const PrintedMarker& marker() const { return marker_; }
  const std::optional<DeskMirror>& mirror() const { return mirror_; }

 private:
  PrintedMarker marker_;
  std::optional<DeskMirror> mirror_;
  int cells_ = 0;  // along a side, with the black border
  double cells_per_metre_ = 0.0;
  std::vector<unsigned char> bits_;  // cells_ x cells_, row 0 at the top; 1 is white
  DeskTexture whole_;                // coarse, to the desk's edges
  DeskTexture near_;                 // fine, around the sheet
};

}  // namespace amalgam::client
