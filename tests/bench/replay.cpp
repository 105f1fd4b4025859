#include "bench/replay.h"

#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

#include "bench/replay_packet.h"

namespace amalgam::bench {
namespace {

constexpr std::size_t kChunk = 256;
const RTCSceneFlags kSceneFlags = RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

template <typename Handle, void (*release)(Handle*)>
struct Release {
  void operator()(Handle* handle) const { release(handle); }
};
using Device = std::unique_ptr<RTCDeviceTy, Release<RTCDeviceTy, rtcReleaseDevice>>;
using SceneHandle = std::unique_ptr<RTCSceneTy, Release<RTCSceneTy, rtcReleaseScene>>;
using Geometry = std::unique_ptr<RTCGeometryTy, Release<RTCGeometryTy, rtcReleaseGeometry>>;

template <typename Element>
void fill_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                 const std::vector<Element>& source) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element), source.size());
  if (buffer == nullptr) throw std::runtime_error("no memory for the replay's scene");
  std::copy(source.begin(), source.end(), static_cast<Element*>(buffer));
}

SceneHandle build_mesh(RTCDevice device, const scene::Mesh& mesh) {
  const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  fill_buffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
  fill_buffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
  rtcCommitGeometry(geometry.get());
  SceneHandle built(rtcNewScene(device));
  rtcSetSceneFlags(built.get(), kSceneFlags);
  rtcSetSceneBuildQuality(built.get(), RTC_BUILD_QUALITY_HIGH);
  rtcAttachGeometry(built.get(), geometry.get());
  rtcCommitScene(built.get());
  return built;
}

}  // namespace

struct Replay::Impl {
  Device device;
  std::vector<SceneHandle> meshes;
  SceneHandle top;
};

Replay::Replay(const scene::Scene& scene, const scene::AnchoredScene& anchored)
    : impl_(std::make_unique<Impl>()) {
  // As many threads as TBB has: any other number would hold for the whole process.
  impl_->device.reset(rtcNewDevice("threads=0,set_affinity=0"));
  if (!impl_->device) throw std::runtime_error("Embree cannot create a device on this processor");
  RTCDevice device = impl_->device.get();
  for (const scene::Mesh& mesh : scene.meshes) impl_->meshes.push_back(build_mesh(device, mesh));
  impl_->top.reset(rtcNewScene(device));
  rtcSetSceneFlags(impl_->top.get(), kSceneFlags | RTC_SCENE_FLAG_DYNAMIC);
  for (const scene::AnchoredInstance& placed : anchored.instances) {
    const scene::Instance& instance = scene.instances[placed.instance];
    const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
    rtcSetGeometryInstancedScene(geometry.get(), impl_->meshes[instance.mesh].get());
    rtcSetGeometryMask(geometry.get(), instance.role == scene::Role::Real ? 1u : 2u);
    rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                            glm::value_ptr(placed.world_from_mesh));
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(impl_->top.get(), geometry.get(), placed.instance);
  }
  rtcCommitScene(impl_->top.get());
}

Replay::~Replay() = default;

void Replay::run(std::span<const trace::LoggedRay> rays, ReplayCall call, int threads,
                 std::span<ReplayAnswer> answers) const {
  const auto answer = call == ReplayCall::OneByOne ? answer_one_by_one : answer_by_eight;
  const std::size_t chunks = (rays.size() + kChunk - 1) / kChunk;
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
      const std::size_t first = chunk * kChunk;
      const std::size_t count = std::min(kChunk, rays.size() - first);
      answer(impl_->top.get(), rays.subspan(first, count), answers.subspan(first, count));
    });
  });
}

}  // namespace amalgam::bench
