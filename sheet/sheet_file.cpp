#include "sheet/sheet_file.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "common/whole_file.h"

namespace amalgam::sheet {
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

// What cairo gives goes to the end of a string.
cairo_status_t append(void* text, const unsigned char* bytes, unsigned size) {
  try {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), size);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::exception&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

std::string svg_of(const MarkerSheet& sheet) {
  std::string bytes;
  const Surface surface(
      cairo_svg_surface_create_for_stream(&append, &bytes, sheet.width, sheet.height),
      &cairo_surface_destroy);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_MM);
  draw(surface, sheet, 1.0);
  return bytes;
}

}  // namespace

std::string pdf_of(const MarkerSheet& sheet) {
  std::string bytes;
  const Surface surface(
      cairo_pdf_surface_create_for_stream(&append, &bytes, sheet.width * kPointsPerMillimetre,
                                          sheet.height * kPointsPerMillimetre),
      &cairo_surface_destroy);
  draw(surface, sheet, kPointsPerMillimetre);
  return bytes;
}

void write_sheet(const std::filesystem::path& file, const MarkerSheet& sheet) {
  const std::string kind = file.extension().string();
  if (kind != ".pdf" && kind != ".svg") {
    throw std::runtime_error(file.string() + ": markers are written as .pdf or .svg");
  }
  if (kind == ".svg" && sheet.pages.size() > 1) {
    throw std::runtime_error(file.string() + ": " + std::to_string(sheet.pages.size()) +
                             " pages are needed, and SVG has one; write a .pdf");
  }
  common::write_whole_file(file, std::string_view(kind == ".pdf" ? pdf_of(sheet) : svg_of(sheet)));
}

}  // namespace amalgam::sheet
