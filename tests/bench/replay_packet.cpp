#include "bench/replay_packet.h"

#include <array>

namespace amalgam::bench {
namespace {

using trace::LoggedRay;
using trace::RayQuery;

constexpr std::size_t kWidth = 8;
constexpr std::uint32_t kNone = RTC_INVALID_GEOMETRY_ID;
constexpr ReplayAnswer kAnyHit{0, 0};

RTCIntersectContext make_context() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  return context;
}

RTCRay to_embree(const LoggedRay& logged) {
  const trace::Ray& ray = logged.ray;
  RTCRay out{};
  out.org_x = ray.origin.x, out.org_y = ray.origin.y, out.org_z = ray.origin.z;
  out.dir_x = ray.direction.x, out.dir_y = ray.direction.y, out.dir_z = ray.direction.z;
  out.tnear = ray.t_min;
  out.tfar = ray.t_max;
  out.mask = static_cast<unsigned>(logged.visible);
  return out;
}

void put(RTCRay8& packet, std::size_t lane, const LoggedRay& logged) {
  const trace::Ray& ray = logged.ray;
  packet.org_x[lane] = ray.origin.x;
  packet.org_y[lane] = ray.origin.y;
  packet.org_z[lane] = ray.origin.z;
  packet.dir_x[lane] = ray.direction.x;
  packet.dir_y[lane] = ray.direction.y;
  packet.dir_z[lane] = ray.direction.z;
  packet.tnear[lane] = ray.t_min;
  packet.tfar[lane] = ray.t_max;
  packet.mask[lane] = static_cast<unsigned>(logged.visible);
}

struct CountingContext {
  RTCIntersectContext embree;  // first: Embree knows only this part
  std::size_t surfaces = 0;
};

// Indices of rays that are answered by one call.
struct Lanes {
  std::array<std::size_t, kWidth> ray{};
  std::size_t count = 0;
  bool full() const { return count == kWidth; }
};

// What EmbreeScene::find_all does with each surface, but for writing it down.
void go_on(const RTCFilterFunctionNArguments* arguments) {
  auto* context = reinterpret_cast<CountingContext*>(arguments->context);
  ++context->surfaces;
  arguments->valid[0] = 0;
}

ReplayAnswer answer_all(RTCScene scene, const LoggedRay& logged) {
  CountingContext context{make_context()};
  context.embree.filter = go_on;
  RTCRay ray = to_embree(logged);
  rtcOccluded1(scene, &context.embree, &ray);
  return context.surfaces > 0 ? kAnyHit : ReplayAnswer{};
}

void answer_nearest(RTCScene scene, std::span<const LoggedRay> rays, Lanes& lanes,
                    std::span<ReplayAnswer> answers) {
  RTCRayHit8 packet{};
  alignas(32) std::array<int, kWidth> valid{};
  for (std::size_t lane = 0; lane < lanes.count; ++lane) {
    valid[lane] = -1;
    put(packet.ray, lane, rays[lanes.ray[lane]]);
    packet.hit.geomID[lane] = packet.hit.instID[0][lane] = kNone;
  }
  RTCIntersectContext context = make_context();
  rtcIntersect8(valid.data(), scene, &context, &packet);
  for (std::size_t lane = 0; lane < lanes.count; ++lane) {
    const bool met = packet.hit.geomID[lane] != kNone;
    answers[lanes.ray[lane]] =
        met ? ReplayAnswer{packet.hit.instID[0][lane], packet.hit.primID[lane]} : ReplayAnswer{};
  }
  lanes.count = 0;
}

void answer_any(RTCScene scene, std::span<const LoggedRay> rays, Lanes& lanes,
                std::span<ReplayAnswer> answers) {
  RTCRay8 packet{};
  alignas(32) std::array<int, kWidth> valid{};
  for (std::size_t lane = 0; lane < lanes.count; ++lane) {
    valid[lane] = -1;
    put(packet, lane, rays[lanes.ray[lane]]);
  }
  RTCIntersectContext context = make_context();
  rtcOccluded8(valid.data(), scene, &context, &packet);
  for (std::size_t lane = 0; lane < lanes.count; ++lane) {
    answers[lanes.ray[lane]] = packet.tfar[lane] < 0.0f ? kAnyHit : ReplayAnswer{};
  }
  lanes.count = 0;
}

}  // namespace

void answer_one_by_one(RTCScene scene, std::span<const LoggedRay> rays,
                       std::span<ReplayAnswer> answers) {
  RTCIntersectContext context = make_context();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rays[i].query == RayQuery::All) {
      answers[i] = answer_all(scene, rays[i]);
    } else if (rays[i].query == RayQuery::Any) {
      RTCRay ray = to_embree(rays[i]);
      rtcOccluded1(scene, &context, &ray);
      answers[i] = ray.tfar < 0.0f ? kAnyHit : ReplayAnswer{};
    } else {
      RTCRayHit query{};
      query.ray = to_embree(rays[i]);
      query.hit.geomID = query.hit.instID[0] = kNone;
      rtcIntersect1(scene, &context, &query);
      answers[i] = query.hit.geomID != kNone ? ReplayAnswer{query.hit.instID[0], query.hit.primID}
                                             : ReplayAnswer{};
    }
  }
}

void answer_by_eight(RTCScene scene, std::span<const LoggedRay> rays,
                     std::span<ReplayAnswer> answers) {
  Lanes nearest, any;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rays[i].query == RayQuery::All) {  // these have no common front that a packet could use
      answers[i] = answer_all(scene, rays[i]);
      continue;
    }
    Lanes& lanes = rays[i].query == RayQuery::Any ? any : nearest;
    lanes.ray[lanes.count++] = i;
    if (nearest.full()) answer_nearest(scene, rays, nearest, answers);
    if (any.full()) answer_any(scene, rays, any, answers);
  }
  if (nearest.count > 0) answer_nearest(scene, rays, nearest, answers);
  if (any.count > 0) answer_any(scene, rays, any, answers);
}

}  // namespace amalgam::bench
