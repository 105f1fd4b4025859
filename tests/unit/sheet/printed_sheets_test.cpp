// What the server gives browsers to print.
#include "server/printed_sheets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "client/tracking/board_description.h"
#include "common/whole_file.h"
#include "sheet/marker_sheet.h"

namespace amalgam {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

const frame::FrameService::MarkerSet kMarkers{"DICT_6X6_250", 0.05, 40, {40, 23}};

std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  std::string text;
  std::array<char, 4096> piece{};
  while (const std::size_t size = std::fread(piece.data(), 1, piece.size(), pipe.get())) {
    text.append(piece.data(), size);
  }
  return text;
}

// What poppler says of a PDF: its page's size and its words.
std::string words_of(const std::string& pdf) {
  const std::string file = testing::TempDir() + "sheet_" + std::to_string(getpid()) + ".pdf";
  common::write_whole_file(file, std::string_view(pdf));
  std::string words = output_of("pdfinfo " + file + "; pdftotext -layout " + file + " -");
  std::filesystem::remove(file);
  return words;
}

// What the page for browsers looks for.
nlohmann::json page_limits() {
  std::ifstream file(AMALGAM_SOURCE_DIR "/client/web/source/lens/limits.json");
  return nlohmann::json::parse(file);
}

TEST(PrintedSheets, AreOfTheScenesMarkersAndOfThePaper) {
  if (std::system("command -v pdftotext >/dev/null") != 0) {
    GTEST_SKIP() << "no pdftotext (Debian's poppler-utils)";
  }
  const auto sheets = printed_sheets("desk.gltf");
  ASSERT_EQ(sheets.size(), 4u);
  const std::string a4 = words_of(sheets.at("/marker-sheet.pdf?paper=a4")(kMarkers));
  EXPECT_THAT(a4, HasSubstr("(A4)"));
  EXPECT_THAT(a4, HasSubstr("desk.gltf"));
  EXPECT_THAT(a4, HasSubstr("DICT_6X6_250: black squares are 50 mm wide"));
  EXPECT_THAT(a4, ContainsRegex("40 +23"));
  // Beside small markers too there is room for their numbers.
  frame::FrameService::MarkerSet small = kMarkers;
  small.marker_length = 0.01;
  EXPECT_THAT(words_of(sheets.at("/marker-sheet.pdf?paper=a4")(small)), ContainsRegex("40 +23"));
  EXPECT_THAT(words_of(sheets.at("/marker-sheet.pdf?paper=letter")(kMarkers)),
              HasSubstr("(letter)"));
  const std::string board = words_of(sheets.at("/lens-board.pdf?paper=a4")(kMarkers));
  EXPECT_THAT(board, HasSubstr("(A4)"));
  EXPECT_THAT(board, HasSubstr("--charuco " + page_limits()["board"].get<std::string>()));
  EXPECT_THAT(words_of(sheets.at("/lens-board.pdf?paper=letter")(kMarkers)), HasSubstr("(letter)"));
}

// The page looks for the board that it is printed with.
TEST(PrintedSheets, TheBoardIsThePages) {
  const nlohmann::json limits = page_limits();
  EXPECT_EQ(limits["dictionary"], sheet::SheetOptions().dictionary);
  const tracking::RegularBoard board = client::parse_charuco(limits["board"]);
  EXPECT_EQ(board.columns, kLensBoard.columns);
  EXPECT_EQ(board.rows, kLensBoard.rows);
  EXPECT_EQ(board.first_length, kLensBoard.first_length);
  EXPECT_EQ(board.second_length, kLensBoard.second_length);
  EXPECT_EQ(board.first_id, kLensBoard.first_id);
}

TEST(PrintedSheets, WhatDoesNotFitIsSaid) {
  const auto make = printed_sheets("desk.gltf").at("/marker-sheet.pdf?paper=a4");
  frame::FrameService::MarkerSet none = kMarkers, wide = kMarkers;
  none.ids.clear();
  wide.marker_length = 0.4;
  EXPECT_THROW(make(none), std::runtime_error);
  EXPECT_THROW(make(wide), std::runtime_error);
}

}  // namespace
}  // namespace amalgam
