#include "server/printed_sheets.h"

#include "sheet/marker_sheet.h"
#include "sheet/sheet_file.h"

namespace amalgam {
namespace {

using Markers = frame::FrameService::MarkerSet;

std::string marker_sheet(const Markers& markers, const std::string& title, const char* paper) {
  sheet::SheetOptions options{.dictionary = markers.dictionary,
                              .ids = markers.ids,
                              .length = markers.marker_length,
                              .title = title};
  sheet::set_paper(options, paper);
  return sheet::pdf_of(sheet::lay_out_markers(options));
}

std::string lens_board(const char* paper) {
  sheet::SheetOptions options{.title =
                                  "To measure a lens: amalgam-client --charuco 5x7:0.032:0.024"};
  sheet::set_paper(options, paper);
  return sheet::pdf_of(sheet::lay_out_charuco(options, kLensBoard));
}

}  // namespace

std::map<std::string, net::MakeFile, std::less<>> printed_sheets(const std::string& title) {
  std::map<std::string, net::MakeFile, std::less<>> sheets;
  for (const char* paper : {"a4", "letter"}) {
    sheets[std::string("/marker-sheet.pdf?paper=") + paper] = [=](const Markers& markers) {
      return marker_sheet(markers, title, paper);
    };
    sheets[std::string("/lens-board.pdf?paper=") + paper] = [=](const Markers&) {
      return lens_board(paper);
    };
  }
  return sheets;
}

}  // namespace amalgam
