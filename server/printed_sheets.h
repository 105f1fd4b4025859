// What the web port gives browsers to print: the scene's markers, and a board to measure a lens
// with.
#pragma once

#include <map>
#include <string>

#include "net/server_config.h"
#include "tracking/marker_board.h"

namespace amalgam {

// The board that the page measures a lens with, of DICT_6X6_250: the largest in whole millimetres
// that fits on US letter too.
inline constexpr tracking::RegularBoard kLensBoard{
    .columns = 5, .rows = 7, .first_length = 0.032, .second_length = 0.024, .first_id = 0};

// /marker-sheet.pdf and /lens-board.pdf, each with ?paper=a4 and ?paper=letter, as PDF. title: on
// each page of markers.
std::map<std::string, net::MakeFile, std::less<>> printed_sheets(const std::string& title);

}  // namespace amalgam
