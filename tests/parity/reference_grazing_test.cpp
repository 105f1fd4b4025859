// Which pixels a renderer in float cannot be held to: edges a known way beside a pixel's centre.
#include <gtest/gtest.h>

#include "parity/closed_form_rig.h"

namespace amalgam::reference {
namespace {

using test_support::make_quad;

constexpr int kCentre = 10;
constexpr double kPixel = 0.1;  // metres at the origin, in its plane

// Seen from (0, 0, 2) along -z, 0.1 m a pixel.
ReferenceImages look(const ClosedFormRig& rig) {
  ReferenceRequest request;
  request.camera = test_support::make_pinhole(2 * kCentre + 1, 2 * kCentre + 1, 20.0);
  request.anchored = rig.anchored();
  request.anchored.camera_from_world = test_support::look_at({0.0, 0.0, 2.0}, {0.0, 0.0, 0.0});
  const common::ImageRgb8 image(request.camera.width, request.camera.height);
  request.camera_image = &image;
  request.find_grazing = true;
  return render_reference(rig.scene, request);
}

Grazing grazing_at_centre(const ReferenceImages& images) {
  return static_cast<Grazing>(images.grazing.at(kCentre, kCentre));
}

// A lamp from x = edge to the right.
ReferenceImages lamp_beside_the_centre(double edge) {
  ClosedFormRig rig;
  const auto half = static_cast<float>((1.0 - edge) / 2.0);
  rig.add(make_quad({1.0f - half, 0.0f, 0.0f}, {half, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}),
          make_lamp());
  return look(rig);
}

TEST(ReferenceGrazing, RasterisersAreUnsureOfA256thOfAPixel) {
  EXPECT_EQ(lamp_beside_the_centre(kPixel / 300.0).rim.at(kCentre, kCentre), 1);
  EXPECT_EQ(lamp_beside_the_centre(-kPixel / 300.0).rim.at(kCentre, kCentre), 1);
  const ReferenceImages away = lamp_beside_the_centre(kPixel / 200.0);
  EXPECT_EQ(away.rim.at(kCentre, kCentre), 0);
  EXPECT_EQ(grazing_at_centre(away), Grazing::No);
}

TEST(ReferenceGrazing, EdgesWithinANudgeAreFound) {
  // 2^-22 at a distance of 2 m.
  EXPECT_EQ(grazing_at_centre(lamp_beside_the_centre(2e-7)), Grazing::Edge);
  EXPECT_EQ(grazing_at_centre(lamp_beside_the_centre(2e-6)), Grazing::No);
}

// A mirror at 45 degrees sends the middle ray along +x; the lamp there begins a little beside it,
// on the side that rays are lifted to: by 32 / 2^23 times 1.4 m.
TEST(ReferenceGrazing, EdgesWithinTheLiftOfReflectedRaysAreFound) {
  const auto look_by_mirror = [](float edge) {
    ClosedFormRig rig;
    rig.add(make_quad(glm::vec3(0.0f), {0.7071068f, 0.0f, -0.7071068f}, {0.0f, 1.0f, 0.0f}),
            test_support::make_mirror());
    const float half = (1.0f - edge) / 2.0f;
    rig.add(make_quad({3.0f, 0.0f, 1.0f - half}, {0.0f, 0.0f, half}, {0.0f, 1.0f, 0.0f}),
            make_lamp());
    return grazing_at_centre(look(rig));
  };
  EXPECT_EQ(look_by_mirror(2e-6f), Grazing::Edge);
  EXPECT_EQ(look_by_mirror(1e-5f), Grazing::No);
  EXPECT_EQ(look_by_mirror(-2e-6f), Grazing::No);  // the other side
}

}  // namespace
}  // namespace amalgam::reference
