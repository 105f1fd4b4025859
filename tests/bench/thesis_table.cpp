#include "bench/thesis_table.h"

#include <array>
#include <stdexcept>

namespace amalgam::bench {
namespace {

using enum ThesisScene;
using enum ThesisMethod;

// Table 6.1, page for page as printed; "4)" there means the same scene at another resolution.
constexpr std::array kTable = std::to_array<ThesisRow>({
    {GlassBunny, 1, 1280, 1024, 1, Rasterizer, 4.2, "A.1"},
    {GlassBunny, 1, 1280, 1024, 1, OurMethod, 3.1, "A.2"},
    {GlassBunny, 4, 1280, 1024, 1, OurMethod, 0.8, "A.3"},
    {GlassBunny, 9, 1280, 1024, 1, OurMethod, 0.5, "A.4"},
    {GlassBunny, 1, 800, 600, 1, Rasterizer, 9.9, "A.1"},
    {GlassBunny, 1, 800, 600, 1, OurMethod, 6.4, "A.2"},
    {MirrorBunny, 1, 1280, 1024, 1, Rasterizer, 7.2, "A.5"},
    {MirrorBunny, 1, 1280, 1024, 1, OurMethod, 8.1, "A.6"},
    {MirrorBunny, 9, 1280, 1024, 1, OurMethod, 2.3, "A.7"},
    {Complex, 1, 800, 600, 1, Rasterizer, 10.9, "A.8"},
    {Complex, 1, 800, 600, 1, RasterizerSecondOrder, 10.2, "A.9"},
    {Complex, 1, 800, 600, 1, OurMethod, 11.1, "A.10"},
    {Complex, 1, 1900, 1100, 1, RasterizerSecondOrder, 1.4, "A.9"},
    {Complex, 1, 1900, 1100, 1, OurMethod, 1.7, "A.10"},
    {Complex, 1, 800, 600, 2, Rasterizer, 17.2, "A.11"},
    {Complex, 1, 800, 600, 2, OurMethod, 22.4, "A.12"},
    {Complex, 1, 800, 600, 1, DiffuseObjects, 25.9, "A.13"},
    {Complex, 1, 800, 600, 1, RayTracer, 6.5, "A.14"},
});

}  // namespace

std::span<const ThesisRow> thesis_table() {
  return kTable;
}

bool is_held_to_goal(const ThesisRow& row) {
  return row.pc == 1 && row.method != Rasterizer && row.method != RasterizerSecondOrder;
}

const char* to_string(ThesisScene scene) {
  switch (scene) {
    case GlassBunny:
      return "glass bunny";
    case MirrorBunny:
      return "mirror bunny";
    case Complex:
      return "complex";
  }
  throw std::logic_error("a scene that is none");
}

const char* to_string(ThesisMethod method) {
  switch (method) {
    case Rasterizer:
      return "rasterizer";
    case RasterizerSecondOrder:
      return "rasterizer, 2nd order";
    case OurMethod:
      return "our method";
    case RayTracer:
      return "ray tracer";
    case DiffuseObjects:
      return "diffuse objects";
  }
  throw std::logic_error("a method that is none");
}

}  // namespace amalgam::bench
