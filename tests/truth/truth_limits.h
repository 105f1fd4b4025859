// How near each scene's composites come to the truth today, over all environments and kinds of
// pictures.
//
// A few per cent above what is measured: drivers and processors move single pixels. What keeps them
// from being lower, in the order of its size:
//  - The exposure takes the real surfaces for a grey card of the model's color. On a table darker
//    than its model all objects are too dark: worst on slate, much on wood.
//  - Diffuse objects get no light from the table, and mirrors and glass that see one show it so.
//  - Eight lights, and 64 for a sky, for an environment: edges and the depth of shadows.
//  - The difference m - r takes the model's color for the table's: shadows on red cloth are
//    saturated, on slate and blue black.
//  - Caustics, and what the camera does not see of the table; one sample a pixel on edges.
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
    {"complex", "default", 32.0, 22.0},         {"complex", "64 lights", 30.0, 18.5},
    {"diffuse", "default", 42.0, 14.0},         {"diffuse", "64 lights", 39.5, 9.5},
    {"glassware", "default", 28.5, 13.5},       {"glassware", "64 lights", 28.0, 12.0},
    {"bunny-glass", "default", 33.5, 18.5},     {"bunny-glass", "64 lights", 33.0, 18.5},
    {"bunny-mirror", "default", 32.0, 16.5},    {"bunny-mirror", "64 lights", 29.0, 10.2},
    {"slate-and-blue", "default", 124.0, 12.8}, {"slate-and-blue", "64 lights", 122.0, 8.6},
};

}  // namespace amalgam::truth
