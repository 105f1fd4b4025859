// Charts drawn by gnuplot, as SVG within a page.
#pragma once

#include <string>

#include "report/chart.h"

namespace amalgam::report {

// Throws std::runtime_error that says what to install if gnuplot is not there.
void check_gnuplot();

// An <svg> element whose ids begin with the prefix. Black is the page's text color. Points that a
// logarithmic axis cannot show are left out; empty if none is left. Throws std::runtime_error with
// gnuplot's words.
std::string draw(const Chart& chart, const std::string& id_prefix);

// The program that draw() gives gnuplot. Empty if there is nothing to draw.
std::string gnuplot_program(const Chart& chart);

}  // namespace amalgam::report
