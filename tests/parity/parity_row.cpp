#include "parity/parity_row.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include "parity/rendering.h"
#include "support/compare_images.h"
#include "support/reference/relative_error.h"

namespace amalgam::parity {
namespace {

using reference::Color;
using reference::Grazing;
using reference::ReferenceImages;
using reference::relative_error;

// One pixel of a buffer of one or three channels; a missing buffer is black.
Color pixel_of(const frame::FrameBuffers& buffers, const std::string& name, int x, int y) {
  const auto found = buffers.find(name);
  if (found == buffers.end()) return Color(0.0);
  if (const auto* image = std::get_if<common::ImageRgb32f>(&found->second)) {
    return Color(image->at(x, y));
  }
  return Color(static_cast<double>(std::get<common::Image32f>(found->second).at(x, y)));
}

// A whole buffer, likewise.
common::ImageRgb32f picture_of(const frame::FrameBuffers& buffers, const std::string& name,
                               const ReferenceImages& expected) {
  common::ImageRgb32f picture(expected.mixed.width(), expected.mixed.height());
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      picture.at(x, y) = glm::vec3(pixel_of(buffers, name, x, y));
    }
  }
  return picture;
}

double traced_error(const frame::FrameBuffers& buffers, const ReferenceImages& expected, int x,
                    int y) {
  const bool met_virtual = expected.virtual_mask.at(x, y) != 0;
  if ((pixel_of(buffers, "virtual_mask", x, y).r > 0.5) != met_virtual) {
    return reference::kInfinity;
  }
  double error = relative_error(pixel_of(buffers, "mixed", x, y), expected.mixed.at(x, y));
  error = std::max(error, relative_error(pixel_of(buffers, "environment_reflection", x, y),
                                         expected.environment_reflection.at(x, y)));
  if (met_virtual) return error;
  return std::max(error, relative_error(pixel_of(buffers, "real", x, y), expected.real.at(x, y)));
}

struct WrongPixel {
  int x, y;
  double error;
};

std::string describe(const std::vector<WrongPixel>& pixels, const frame::FrameBuffers& buffers,
                     const ReferenceImages& expected) {
  std::ostringstream text;
  text << std::setprecision(6);
  const auto put = [&](const char* name, const Color& actual, const Color& wanted) {
    text << "\n    " << name << " (" << actual.r << ' ' << actual.g << ' ' << actual.b
         << ") reference (" << wanted.r << ' ' << wanted.g << ' ' << wanted.b << ')';
  };
  for (const auto& [x, y, error] : pixels) {
    text << "\n  (" << x << ", " << y << ") error " << error << ", M_v "
         << pixel_of(buffers, "virtual_mask", x, y).r << " reference "
         << int{expected.virtual_mask.at(x, y)};
    put("mixed", pixel_of(buffers, "mixed", x, y), expected.mixed.at(x, y));
    put("real", pixel_of(buffers, "real", x, y), expected.real.at(x, y));
  }
  return text.str();
}

// Pixels that see a surface. In hybrid mode those whose first surface is specular.
bool is_traced(const ReferenceImages& expected, frame::RendererMode mode, int x, int y) {
  return mode == frame::RendererMode::Raytrace || expected.specular_mask.at(x, y) != 0;
}

void compare_traced(const frame::FrameBuffers& buffers, const ReferenceImages& expected,
                    frame::RendererMode mode, ParityRow& row) {
  std::vector<WrongPixel> wrong;
  double sum = 0.0;
  row.traced_errors = common::Image<double>(expected.mixed.width(), expected.mixed.height());
  for (int y = 0; y < expected.mixed.height(); ++y) {
    for (int x = 0; x < expected.mixed.width(); ++x) {
      if (!is_traced(expected, mode, x, y)) continue;
      ++row.traced;
      const double error = traced_error(buffers, expected, x, y);
      if (mode == frame::RendererMode::Hybrid && expected.rim.at(x, y) != 0) {
        ++row.rim;
        continue;
      }
      const auto grazing = static_cast<Grazing>(expected.grazing.at(x, y));
      if (grazing != Grazing::No) {
        ++(grazing == Grazing::Edge ? row.edge : row.steep);
        row.traced_wrong_grazing += error > kTracedTolerance ? 1 : 0;
        continue;
      }
      sum += error;
      row.traced_errors.at(x, y) = error;
      row.traced_maximum = std::max(row.traced_maximum, error);
      if (error > kTracedTolerance) wrong.push_back({x, y, error});
    }
  }
  row.traced_wrong = wrong.size();
  row.traced_mean = sum / static_cast<double>(std::max<std::size_t>(
                              1, row.traced - row.edge - row.steep - row.rim));
  std::sort(wrong.begin(), wrong.end(),
            [](const WrongPixel& a, const WrongPixel& b) { return a.error > b.error; });
  wrong.resize(std::min<std::size_t>(wrong.size(), 10));
  row.worst = describe(wrong, buffers, expected);
}

void compare_composites(const common::ImageRgb8& actual, const ReferenceImages& expected,
                        frame::RendererMode mode, ParityRow& row) {
  const auto comparison = test_support::compare_images(test_support::as_floats(actual),
                                                       test_support::as_floats(expected.composite));
  row.composite_mean = comparison.mean;
  row.composite_maximum = comparison.maximum;
  for (int y = 0; y < actual.height(); ++y) {
    for (int x = 0; x < actual.width(); ++x) {
      const glm::ivec3 step =
          glm::abs(glm::ivec3(actual.at(x, y)) - glm::ivec3(expected.composite.at(x, y)));
      if (std::max({step.r, step.g, step.b}) <= 3) continue;
      ++row.composite_wrong;
      row.composite_wrong_rasterised += is_traced(expected, mode, x, y) ? 0 : 1;
    }
  }
}

}  // namespace

ParityRow compare_rendering(Rendering actual, const ReferenceImages& expected,
                            frame::RendererMode mode) {
  ParityRow row;
  row.pixels = actual.composite.pixels().size();
  row.nonfinite = actual.statistics.nonfinite;
  compare_traced(actual.buffers, expected, mode, row);
  compare_composites(actual.composite, expected, mode, row);
  row.mixed = picture_of(actual.buffers, "mixed", expected);
  row.real = picture_of(actual.buffers, "real", expected);
  row.composite = std::move(actual.composite);
  return row;
}

ParityRow compare_with_reference(const ParityCase& parity_case, frame::RendererMode mode) {
  const ReferenceImages& expected = reference_images(parity_case);
  frame::RendererSettings settings;
  settings.mode = mode;
  settings.trace_shadow_edges = true;
  return compare_rendering(render(parity_case, settings), expected, mode);
}

std::string table_header() {
  return "case                            renderer  traced   edge %  steep %    rim %  mean error  "
         "max error  wrong  wrong+grazing | composite mean  max  within 3 %  off, rasterised\n";
}

std::string table_line(const ParityCase& parity_case, frame::RendererMode mode,
                       const ParityRow& row) {
  const double percent = 100.0 / static_cast<double>(row.pixels);
  std::ostringstream line;
  line << std::left << std::setw(32) << parity_case.name << std::setw(8) << mode_name(mode)
       << std::right << std::fixed << std::setw(8) << row.traced << std::setprecision(3)
       << std::setw(9) << percent * static_cast<double>(row.edge) << std::setw(9)
       << percent * static_cast<double>(row.steep) << std::setw(9)
       << percent * static_cast<double>(row.rim) << std::scientific << std::setprecision(2)
       << std::setw(12) << row.traced_mean << std::setw(11) << row.traced_maximum << std::setw(7)
       << row.traced_wrong << std::setw(15) << row.traced_wrong_grazing << " | " << std::fixed
       << std::setprecision(4) << std::setw(14) << row.composite_mean << std::setprecision(0)
       << std::setw(5) << row.composite_maximum << std::setprecision(3) << std::setw(12)
       << 100.0 - percent * static_cast<double>(row.composite_wrong) << std::setw(17)
       << row.composite_wrong_rasterised << '\n';
  return line.str();
}

}  // namespace amalgam::parity
