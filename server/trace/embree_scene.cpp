#include "trace/embree_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/log.h"
#include "trace/embree_isa.h"
#include "trace/embree_range.h"
#include "trace/refine_hit.h"

namespace amalgam::trace {
namespace {

struct DeviceDeleter {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneDeleter {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct GeometryDeleter {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, DeviceDeleter>;
using SceneHandle = std::unique_ptr<RTCSceneTy, SceneDeleter>;
using Geometry = std::unique_ptr<RTCGeometryTy, GeometryDeleter>;

void report_error(void*, RTCError code, const char* text) {
  common::log_error("embree error " + std::to_string(code) + ": " + (text ? text : ""));
}

// Embree's calls return nothing that could tell: what they built may be empty.
void throw_pending_error(RTCDevice device, const std::string& doing) {
  const RTCError code = rtcGetDeviceError(device);
  if (code != RTC_ERROR_NONE) {
    throw std::runtime_error(doing + ": embree error " + std::to_string(code));
  }
}

// Robust: no cracks at shared edges (numerics B11). The filters are for rays that
// leave a surface.
const RTCSceneFlags kSceneFlags = RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

// Copies a mesh's data into buffers that Embree owns (it reads 16 bytes past the last vertex
// otherwise).
SceneHandle build_mesh(RTCDevice device, const scene::Mesh& mesh) {
  Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  auto* vertices = static_cast<glm::vec3*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              sizeof(glm::vec3), mesh.positions.size()));
  auto* triangles = static_cast<glm::uvec3*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              sizeof(glm::uvec3), mesh.triangles.size()));
  if (vertices == nullptr || triangles == nullptr) {
    throw std::runtime_error("no memory for the BVH of mesh '" + mesh.name + "'");
  }
  std::copy(mesh.positions.begin(), mesh.positions.end(), vertices);
  std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
  rtcCommitGeometry(geometry.get());

  SceneHandle built(rtcNewScene(device));
  rtcSetSceneFlags(built.get(), kSceneFlags);
  rtcSetSceneBuildQuality(built.get(), RTC_BUILD_QUALITY_HIGH);
  rtcAttachGeometry(built.get(), geometry.get());
  rtcCommitScene(built.get());
  throw_pending_error(device, "the BVH of mesh '" + mesh.name + "'");
  return built;
}

glm::dmat3 normal_matrix(const glm::mat4& world_from_mesh) {
  const glm::dmat3 m(world_from_mesh);
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                             glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0.0 ? -cofactors : cofactors;
}

void fill(RTCRay& out, const Ray& ray, Visible visible) {
  out.org_x = ray.origin.x;
  out.org_y = ray.origin.y;
  out.org_z = ray.origin.z;
  out.dir_x = ray.direction.x;
  out.dir_y = ray.direction.y;
  out.dir_z = ray.direction.z;
  out.tnear = ray.t_min;
  out.tfar = ray.t_max;
  out.time = 0.0f;
  out.mask = static_cast<unsigned>(visible);
  out.id = 0;
  out.flags = 0;
}

double largest_element(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

bool is_textured_instance(const scene::Scene& scene, const scene::Instance& instance) {
  const scene::Mesh& mesh = scene.meshes[instance.mesh];
  const scene::Material& material = scene.materials[instance.material];
  return !mesh.colors.empty() ||
         std::any_of(
             scene::kAllTextureSlots.begin(), scene::kAllTextureSlots.end(),
             [&](scene::TextureSlot slot) { return scene::has_texture(material, mesh, slot); });
}

bool passes_light(const scene::Material& material) {
  return material.kind == scene::MaterialKind::Dielectric || material.alpha_cutoff.has_value();
}

// Passed through Embree to the filters.
struct LeavingContext {
  RTCIntersectContext embree;  // first: Embree knows only this part
  const EmbreeScene* scene = nullptr;
  const glm::dvec3* start = nullptr;
  const Ray* ray = nullptr;
  // Of find_all() only.
  PassedSurfaces* found = nullptr;
  const std::uint8_t* ends_light = nullptr;
};

Hit met_by(const RTCFilterFunctionNArguments* arguments) {
  const auto* ray = reinterpret_cast<const RTCRay*>(arguments->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
  return {hit->instID[0], hit->primID, {hit->u, hit->v}, ray->tfar};
}

// Embree's filter that lets the ray continue past the surface that it leaves.
void pass_left_behind(const RTCFilterFunctionNArguments* arguments) {
  const auto& context = *reinterpret_cast<const LeavingContext*>(arguments->context);
  if (is_left_behind(*context.scene, met_by(arguments), *context.start, *context.ray)) {
    arguments->valid[0] = 0;
  }
}

// Embree's filter for each surface on the ray: records it and lets the ray continue.
void write_down(const RTCFilterFunctionNArguments* arguments) {
  const auto& context = *reinterpret_cast<const LeavingContext*>(arguments->context);
  const Hit met = met_by(arguments);
  context.scene->triangle(met).prefetch();
  if (!is_left_behind(*context.scene, met, *context.start, *context.ray)) {
    if (context.ends_light[met.instance] != 0) return;  // accepted: the query ends
    context.found->add(met);
  }
  arguments->valid[0] = 0;
}

}  // namespace

void PlacedInstance::place(const glm::mat4& placement) {
  world_from_mesh = placement;
  mesh_from_world = glm::inverse(world_from_mesh);
  normal_from_mesh = normal_matrix(placement);
  stretch = std::max({largest_element(world_from_mesh[0]), largest_element(world_from_mesh[1]),
                      largest_element(world_from_mesh[2])});
  reach = largest_element(world_from_mesh[3]);
}

struct EmbreeScene::Impl {
  Device device;
  std::vector<SceneHandle> meshes;
  std::vector<Geometry> instances;  // by Scene::instances; Embree's geometry id is the same index
  SceneHandle top;
};

EmbreeScene::EmbreeScene(const scene::Scene& scene)
    : scene_(scene),
      mesh_bounds_(scene::mesh_bounds(scene)),
      placed_(scene.instances.size()),
      named_(scene.instances.size()),
      last_placed_(scene.instances.size()),
      impl_(std::make_unique<Impl>()) {
  const std::string config = embree_device_config();
  impl_->device.reset(rtcNewDevice(config.c_str()));
  if (!impl_->device) {
    throw std::runtime_error("Embree cannot create a device on this processor (" + config + ")");
  }
  rtcSetDeviceErrorFunction(impl_->device.get(), report_error, nullptr);
  for (const scene::Mesh& mesh : scene.meshes) {
    impl_->meshes.push_back(build_mesh(impl_->device.get(), mesh));
  }
  impl_->top.reset(rtcNewScene(impl_->device.get()));
  rtcSetSceneFlags(impl_->top.get(), kSceneFlags | RTC_SCENE_FLAG_DYNAMIC);
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const scene::Instance& instance = scene.instances[i];
    Geometry geometry(rtcNewGeometry(impl_->device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
    rtcSetGeometryInstancedScene(geometry.get(), impl_->meshes[instance.mesh].get());
    rtcSetGeometryMask(geometry.get(), instance.role == scene::Role::Real ? 1u : 2u);
    rtcAttachGeometryByID(impl_->top.get(), geometry.get(), i);
    rtcDisableGeometry(geometry.get());
    rtcCommitGeometry(geometry.get());
    impl_->instances.push_back(std::move(geometry));
  }
  rtcCommitScene(impl_->top.get());
  throw_pending_error(impl_->device.get(), "the BVH of the scene");

  for (const scene::Mesh& mesh : scene.meshes) triangles_.push_back(mesh_triangles(mesh));
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const scene::Instance& instance = scene.instances[i];
    placed_[i].triangles = triangles_[instance.mesh].data();
    placed_[i].material = instance.material;
    placed_[i].role = instance.role;
    placed_[i].textured = is_textured_instance(scene, instance);
    const bool passes = passes_light(scene.materials[instance.material]);
    ends_light_.push_back(!passes && instance.role == scene::Role::Real ? 1 : 0);
    anything_passes_light_ = anything_passes_light_ || passes;
  }
}

EmbreeScene::~EmbreeScene() = default;

EmbreeScene::Placements EmbreeScene::placements(const scene::AnchoredScene& anchored) const {
  Placements placements(placed_.size());
  for (const scene::AnchoredInstance& a : anchored.instances) {
    if (is_traceable(a.world_from_mesh)) placements[a.instance] = a.world_from_mesh;
  }
  return placements;
}

// Debian's Embree asserts on rays that it cannot trace, also after an instance's transform.
bool EmbreeScene::is_valid(const Ray& ray) const {
  const auto in_range = [](const glm::vec3& v, double range) {
    return std::abs(v.x) < range && std::abs(v.y) < range && std::abs(v.z) < range;
  };
  return in_range(ray.origin, start_range_) && in_range(ray.direction, kFarthestStart) &&
         ray.t_min >= 0.0f && ray.t_max > ray.t_min;
}

bool EmbreeScene::is_placed(const scene::AnchoredScene& anchored) const {
  return whole_ && placements(anchored) == last_placed_;
}

void EmbreeScene::place(const scene::AnchoredScene& anchored) {
  Placements next = placements(anchored);
  const bool were_whole = std::exchange(whole_, false);
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (were_whole && next[i] == last_placed_[i]) continue;
    RTCGeometry geometry = impl_->instances[i].get();
    if (next[i]) {
      placed_[i].place(*next[i]);
      rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                              glm::value_ptr(*next[i]));
      rtcEnableGeometry(geometry);
    } else {
      rtcDisableGeometry(geometry);
    }
    rtcCommitGeometry(geometry);
  }
  rtcCommitScene(impl_->top.get());
  throw_pending_error(impl_->device.get(), "placing the scene's objects");
  whole_ = true;
  last_placed_ = std::move(next);
  start_range_ = kFarthestStart;
  for (const auto& placement : last_placed_) {
    if (placement) start_range_ = std::min(start_range_, start_range(*placement));
  }
  name_untraceable(anchored);
}

void EmbreeScene::name_untraceable(const scene::AnchoredScene& anchored) {
  for (const scene::AnchoredInstance& a : anchored.instances) {
    if (named_[a.instance] != 0 || is_traceable(a.world_from_mesh)) continue;
    named_[a.instance] = 1;
    common::log_warn("an instance of mesh '" +
                     scene_.meshes[scene_.instances[a.instance].mesh].name +
                     "' is too small for how far away it is, not traced");
  }
}

scene::Bounds EmbreeScene::world_bounds(std::uint32_t instance) const {
  scene::Bounds bounds{glm::vec3(std::numeric_limits<float>::max()),
                       glm::vec3(std::numeric_limits<float>::lowest())};
  for (const glm::dvec3& corner :
       scene::placed_corners(mesh_bounds_[scene_.instances[instance].mesh],
                             glm::mat4(placed_[instance].world_from_mesh))) {
    bounds.low = glm::min(bounds.low, glm::vec3(corner));
    bounds.high = glm::max(bounds.high, glm::vec3(corner));
  }
  return bounds;
}

std::optional<Hit> EmbreeScene::intersect(const Ray& ray, Visible visible) const {
  if (!is_valid(ray)) return std::nullopt;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  fill(query.ray, ray, visible);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(impl_->top.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return Hit{query.hit.instID[0], query.hit.primID, {query.hit.u, query.hit.v}, query.ray.tfar};
}

bool EmbreeScene::is_occluded(const Ray& ray, Visible visible) const {
  if (!is_valid(ray)) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query{};
  fill(query, ray, visible);
  rtcOccluded1(impl_->top.get(), &context, &query);
  return query.tfar < 0.0f;
}

bool EmbreeScene::is_occluded(const glm::dvec3& start, const Ray& ray, Visible visible) const {
  if (!is_valid(ray)) return false;
  LeavingContext context{.embree = {}, .scene = this, .start = &start, .ray = &ray};
  rtcInitIntersectContext(&context.embree);
  context.embree.filter = pass_left_behind;
  RTCRay query{};
  fill(query, ray, visible);
  rtcOccluded1(impl_->top.get(), &context.embree, &query);
  return query.tfar < 0.0f;
}

bool EmbreeScene::find_all(const glm::dvec3& start, const Ray& ray, Visible visible,
                           PassedSurfaces& found) const {
  found.clear();
  if (!is_valid(ray)) return false;
  LeavingContext context{.embree = {},
                         .scene = this,
                         .start = &start,
                         .ray = &ray,
                         .found = &found,
                         .ends_light = ends_light_.data()};
  rtcInitIntersectContext(&context.embree);
  context.embree.filter = write_down;
  RTCRay query{};
  fill(query, ray, visible);
  rtcOccluded1(impl_->top.get(), &context.embree, &query);
  return query.tfar < 0.0f;
}

}  // namespace amalgam::trace
