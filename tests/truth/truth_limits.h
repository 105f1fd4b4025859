// How near each scene's composites come to the truth today, over all environments and kinds of
// pictures.
//
// A few per cent above what is measured: drivers and processors move single pixels. What keeps them
// from being lower, in the order of its size:
//  - Diffuse objects get no light from the table, and mirrors and glass that see one show it so.
//  - Caustics, and what the camera does not see of the table.
//  - Eight lights, or 64 for a sky, for an environment: edges and the depth of shadows.
//  - One sample a pixel: glass and its edges are aliased.
//  - Paper and ink that are not quite as white and black as they are taken to be; the exposure
//  where
//    the camera clips the paper.
//  - The truth's own noise, as printed.
#pragma once

#include <string_view>

namespace amalgam::truth {

// Of the mean differences, in 1/255.
struct Limit {
  std::string_view truth_case, method;
  double objects, real;
};

constexpr Limit kLimits[] = {
    {"complex", "default", 24.4, 21.7},        {"complex", "64 lights", 21.4, 17.0},
    {"diffuse", "default", 20.6, 11.4},        {"diffuse", "64 lights", 17.0, 7.3},
    {"glassware", "default", 25.7, 10.8},      {"glassware", "64 lights", 25.2, 9.9},
    {"bunny-glass", "default", 29.4, 17.4},    {"bunny-glass", "64 lights", 28.7, 17.3},
    {"bunny-mirror", "default", 28.6, 11.4},   {"bunny-mirror", "64 lights", 27.7, 8.0},
    {"slate-and-blue", "default", 26.4, 12.0}, {"slate-and-blue", "64 lights", 21.6, 7.3},
};

}  // namespace amalgam::truth
