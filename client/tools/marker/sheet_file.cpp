#include "client/tools/marker/sheet_file.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <memory>
#include <stdexcept>

#include "common/whole_file.h"

namespace amalgam::tools {
namespace {

constexpr double kPointsPerMillimetre = 72.0 / 25.4;
constexpr double kLine = 0.2;  // mm: the ruler's

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

void fill(cairo_t* context, const Square& square, double grey) {
  cairo_set_source_rgb(context, grey, grey, grey);
  cairo_rectangle(context, square.x, square.y, square.side, square.side);
  cairo_fill(context);
}

void draw_ruler(cairo_t* context, const Ruler& ruler) {
  cairo_set_source_rgb(context, 0.0, 0.0, 0.0);
  cairo_set_line_width(context, kLine);
  cairo_move_to(context, ruler.x, ruler.y);
  cairo_line_to(context, ruler.x + ruler.length, ruler.y);
  for (int i = 0; i <= 10; ++i) {
    const double x = ruler.x + ruler.length * i / 10.0;
    const double tick = i % 5 == 0 ? 3.0 : 2.0;
    cairo_move_to(context, x, ruler.y);
    cairo_line_to(context, x, ruler.y - tick);
  }
  cairo_stroke(context);
}

void draw_page(cairo_t* context, const MarkerSheet& sheet, const SheetPage& page) {
  cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
  cairo_paint(context);
  // Edges that fall between a printer's dots must not become grey.
  cairo_set_antialias(context, CAIRO_ANTIALIAS_NONE);
  for (const Square& square : page.black) fill(context, square, 0.0);
  for (const SheetMarker& marker : page.markers) {
    fill(context, marker.outline, 0.0);
    for (const Square& cell : marker.white) fill(context, cell, 1.0);
  }
  draw_ruler(context, sheet.ruler);
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, sheet.font_size);
  cairo_set_source_rgb(context, 0.27, 0.27, 0.27);
  for (const SheetText& text : page.texts) {
    cairo_move_to(context, text.x, text.y);
    cairo_show_text(context, text.text.c_str());
  }
  cairo_show_page(context);
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw std::runtime_error(std::string("the markers cannot be written: ") +
                           cairo_status_to_string(status));
}

void draw(const Surface& surface, const MarkerSheet& sheet, double units_per_millimetre) {
  {
    const Context context(cairo_create(surface.get()), &cairo_destroy);
    cairo_scale(context.get(), units_per_millimetre, units_per_millimetre);
    for (const SheetPage& page : sheet.pages) draw_page(context.get(), sheet, page);
    // A text that it cannot draw ends a context, which the surface does not hear of.
    check(cairo_status(context.get()));
  }
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
}

void write_pdf(const std::filesystem::path& file, const MarkerSheet& sheet) {
  const Surface surface(cairo_pdf_surface_create(file.c_str(), sheet.width * kPointsPerMillimetre,
                                                 sheet.height * kPointsPerMillimetre),
                        &cairo_surface_destroy);
  draw(surface, sheet, kPointsPerMillimetre);
}

void write_svg(const std::filesystem::path& file, const MarkerSheet& sheet) {
  if (sheet.pages.size() > 1) {
    throw std::runtime_error(file.string() + ": " + std::to_string(sheet.pages.size()) +
                             " pages are needed, and SVG has one; write a .pdf");
  }
  const Surface surface(cairo_svg_surface_create(file.c_str(), sheet.width, sheet.height),
                        &cairo_surface_destroy);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_MM);
  draw(surface, sheet, 1.0);
}

}  // namespace

void write_sheet(const std::filesystem::path& file, const MarkerSheet& sheet) {
  const std::string kind = file.extension().string();
  if (kind != ".pdf" && kind != ".svg") {
    throw std::runtime_error(file.string() + ": markers are written as .pdf or .svg");
  }
  common::write_whole_file(file, [&](const std::filesystem::path& part) {
    kind == ".pdf" ? write_pdf(part, sheet) : write_svg(part, sheet);
  });
}

}  // namespace amalgam::tools
