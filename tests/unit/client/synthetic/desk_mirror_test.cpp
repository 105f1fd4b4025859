#include "client/synthetic/desk_mirror.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "client/synthetic/synthetic_camera.h"
#include "client/synthetic/synthetic_path.h"
#include "client/tracking/calibration.h"
#include "client/tracking/marker_tracker.h"

namespace amalgam::client {
namespace {

using nlohmann::json;

// The scene's node "real mirror" and the color of its material.
struct SceneMirror {
  glm::dmat4 marker_from_box{1.0};
  double color = 0.0;
};

SceneMirror mirror_of_scene() {
  const json gltf =
      json::parse(std::ifstream(AMALGAM_SOURCE_DIR "/deploy/scenes/complex.gltf"), nullptr, true);
  SceneMirror mirror;
  for (const json& node : gltf.at("nodes")) {
    if (node.at("name") != "real mirror") continue;
    const auto t = node.at("translation").get<std::vector<double>>();
    const auto q = node.at("rotation").get<std::vector<double>>();
    const auto s = node.at("scale").get<std::vector<double>>();
    glm::dmat4 box = glm::mat4_cast(glm::dquat(q[3], q[0], q[1], q[2]));
    for (int i = 0; i < 3; ++i) box[i] *= s[static_cast<std::size_t>(i)];
    box[3] = {t[0], t[1], t[2], 1.0};
    mirror.marker_from_box = common::opencv_marker_from_gltf() * box;
    const json& primitive =
        gltf.at("meshes").at(node.at("mesh").get<std::size_t>())["primitives"][0];
    mirror.color = gltf.at("materials")
                       .at(primitive.at("material").get<std::size_t>())
                       .at("pbrMetallicRoughness")["baseColorFactor"][0];
  }
  return mirror;
}

glm::dvec3 on_box(const SceneMirror& mirror, const glm::dvec3& p) {
  return glm::dvec3(mirror.marker_from_box * glm::dvec4(p, 1.0));
}

// Each face is met at its middle and near its corners, and nothing beside it.
TEST(DeskMirror, StandsWhereTheSceneHasIt) {
  const SceneMirror scene = mirror_of_scene();
  ASSERT_GT(scene.color, 0.0);
  const DeskMirror mirror;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      for (const double s : {-0.499, 0.0, 0.499, 0.501}) {
        glm::dvec3 at(0.0);
        at[axis] = side;
        at[(axis + 1) % 3] = s;
        at[(axis + 2) % 3] = -s;
        at.y += 0.5;
        glm::dvec3 step(0.0);
        step[axis] = side > 0 ? 1.0 : -1.0;
        const glm::dvec3 outward =
            glm::normalize(glm::transpose(glm::inverse(glm::dmat3(scene.marker_from_box))) * step);
        const glm::dvec3 point = on_box(scene, at);
        const auto met = mirror.meet(point + 0.3 * outward, -0.1 * outward);
        ASSERT_EQ(met.has_value(), std::abs(s) < 0.5) << axis << " " << side << " " << s;
        if (!met) continue;
        EXPECT_NEAR(met->t, 3.0, 1e-9);
        EXPECT_LT(glm::distance(met->normal, outward), 1e-9);
        EXPECT_FALSE(mirror.meet(point + 0.3 * outward, outward)) << "behind the ray";
      }
    }
  }
}

TEST(DeskMirror, DimsByTheColorOfTheScene) {
  const double color = mirror_of_scene().color;
  const auto srgb = [](double linear) {
    return 255.0 * (1.055 * std::pow(linear, 1 / 2.4) - 0.055);
  };
  EXPECT_NEAR(static_cast<double>(DeskMirror::dim(0xFFFFFF, 1.0) & 255), srgb(color), 0.51);
  EXPECT_EQ(DeskMirror::dim(0x000000, 1.0), 0u);
  EXPECT_EQ(DeskMirror::dim(0x4080FF, 0.0), 0x4080FFu) << "nothing is lost at grazing angles";
  EXPECT_GT(DeskMirror::dim(0xFFFFFF, 0.2) & 255, DeskMirror::dim(0xFFFFFF, 1.0) & 255);
}

std::shared_ptr<const SyntheticDesk> desk() {
  static const auto shared = std::make_shared<const SyntheticDesk>(PrintedMarker{}, DeskMirror());
  return shared;
}

// A plane mirror shows what a camera on its other side would see: the desk's points at their mirror
// images.
TEST(DeskMirror, ShowsTheDeskFromBehind) {
  const SceneMirror scene = mirror_of_scene();
  const common::CameraModel camera = common::default_camera(801, 601);
  const auto pose = look_at({0.0, -0.15, 0.5}, {-0.12, 0.15, 0.05}, 40);
  const auto with = SyntheticCamera(camera, desk()).render(pose);
  const glm::dmat4 camera_from_marker = common::to_matrix(pose);
  const glm::dvec3 eye(common::rigid_inverse(camera_from_marker)[3]);
  const glm::dvec3 place = on_box(scene, {0.0, 0.5, 0.5});
  const glm::dvec3 normal = glm::normalize(place - on_box(scene, {0.0, 0.5, -0.5}));
  const DeskMirror mirror;
  int compared = 0;
  double difference = 0.0;
  for (double x = -0.3; x < 0.3; x += 0.01) {
    for (double y = -0.2; y < 0.12; y += 0.01) {
      const glm::dvec3 point(x, y, 0.0);
      const glm::dvec3 image = point - 2.0 * glm::dot(point - place, normal) * normal;
      const auto pixel =
          common::project(camera, glm::dvec3(camera_from_marker * glm::dvec4(image, 1.0)));
      const auto met = mirror.meet(eye, image - eye);
      if (!pixel || !met || glm::dot(met->normal, normal) < 0.99) continue;
      const glm::ivec2 at(std::lround(pixel->x), std::lround(pixel->y));
      if (at.x < 1 || at.y < 1 || at.x >= 800 || at.y >= 600) continue;
      const double cosine = -glm::dot(glm::normalize(image - eye), normal);
      const PackedColor expected = DeskMirror::dim(desk()->color({x, y}, 0.0005), cosine);
      difference += std::abs(int{with.at(at.x, at.y).g} - static_cast<int>(expected >> 8 & 255));
      ++compared;
    }
  }
  ASSERT_GT(compared, 100);
  std::printf("%d points of the desk in the mirror, off by %.2f/255 in the mean\n", compared,
              difference / compared);
  // Points fall up to half a pixel beside pixels' centres, on edges of things too.
  EXPECT_LT(difference / compared, 8.0);
}

// Seen in a mirror the marker is no marker: found poses stay those of the real one.
TEST(DeskMirror, TheMarkerInItIsNotTakenForOne) {
  const common::CameraModel camera = common::default_camera(800, 600);
  const SyntheticCamera synthetic(camera, desk());
  MarkerTracker tracker({}, camera);
  for (std::uint64_t frame = 0; frame < kSyntheticPeriod; frame += 60) {
    const SyntheticFrame made = synthetic.render(frame);
    const auto poses = tracker.track(made.image);
    ASSERT_EQ(poses.size(), 1u) << frame;
    EXPECT_EQ(poses[0].marker, 40);
    EXPECT_LT(glm::distance(poses[0].translation, made.pose.translation), 0.0015) << frame;
  }
}

}  // namespace
}  // namespace amalgam::client
