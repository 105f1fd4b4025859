// Small scenes made by formula, for tests of the rasteriser, the tracer and the frame.
//
// World frame: right-handed, +Y up, metres. Meshes have outward normals and counter-clockwise faces
// seen from outside.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "common/camera_model.h"
#include "common/pose.h"
#include "passes/frame_resources.h"
#include "scene/light/light.h"
#include "scene/scene.h"

namespace amalgam::test_support {

// A parallelogram centre + s half_u + t half_v, s and t in [-1, 1]; normal half_u x half_v;
// uv (0, 0) at s = -1, t = 1, and (1, 1) at s = 1, t = -1.
scene::Mesh make_quad(const glm::vec3& centre, const glm::vec3& half_u, const glm::vec3& half_v);

// A horizontal square facing up.
scene::Mesh make_floor(float height, float half_side);

// An axis-aligned box with flat normals; every face has uv from (0, 0) to (1, 1).
scene::Mesh make_box(const glm::vec3& low, const glm::vec3& high);

// A sphere of slices x stacks with exact normals; poles on the y axis.
scene::Mesh make_sphere(const glm::vec3& centre, float radius, int slices = 32, int stacks = 16);

scene::Material make_diffuse(const glm::vec3& base_color, float roughness = 1.0f);
scene::Material make_mirror(const glm::vec3& base_color = glm::vec3(1.0f));
scene::Material make_glass(float ior = 1.5f, const glm::vec3& absorption = glm::vec3(0.0f));

// Appends a mesh, its material and one instance of it on the world marker; returns the instance.
scene::Instance& add_object(scene::Scene& scene, scene::Mesh mesh, scene::Material material,
                            scene::Role role, const glm::mat4& anchor_from_mesh = glm::mat4(1.0f));

scene::Light make_sun(const glm::vec3& to_light, const glm::vec3& irradiance = glm::vec3(3.0f));
scene::Light make_point_light(const glm::vec3& position, const glm::vec3& intensity);

// A pinhole camera whose principal point is the image's centre.
common::CameraModel make_pinhole(int width, int height, double focal_length);

// camera_from_world of a camera at eye that looks at target (x right, y down, z forward).
glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target,
                   const glm::dvec3& up = glm::dvec3(0.0, 1.0, 0.0));

// The pose of a marker whose glTF frame (the world's axes, see above) is placed so.
common::MarkerPose make_pose(int marker, const glm::dmat4& camera_from_anchor);

// All instances of the scene anchored as they are, seen by an undistorted camera.
passes::RenderView make_view(const scene::Scene& scene, const common::CameraModel& camera,
                             const glm::dmat4& camera_from_world, std::vector<scene::Light> lights,
                             int samples_per_side = 1);

}  // namespace amalgam::test_support
