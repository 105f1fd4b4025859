#include "bench/micro/micro_benchmarks.h"

#include "bench/micro/benchmarks.h"

namespace amalgam::bench {
namespace {

struct Entry {
  const char* name;
  void (*run)(benchmark::State& state);
};

constexpr Entry kEntries[] = {
    {"fresnel_schlick", benchmark_fresnel_schlick},
    {"fresnel_exact", benchmark_fresnel_exact},
    {"refract", benchmark_refract},
    {"tone_map", benchmark_tone_map},
    {"srgb_encode", benchmark_srgb_encode},
    {"sample_environment", benchmark_sample_environment},
    {"composite", benchmark_composite},
    {"decode", benchmark_decode},
    {"encode", benchmark_encode},
    {"bright_frame", benchmark_bright_frame},
    {"denormal_frame", benchmark_denormal_frame},
};

}  // namespace

void register_micro_benchmarks(const std::filesystem::path& scene_folder) {
  for (const Entry& entry : kEntries) benchmark::RegisterBenchmark(entry.name, entry.run);
  benchmark::RegisterBenchmark("intersect", [scene_folder](benchmark::State& state) {
    benchmark_intersect(state, scene_folder);
  });
  benchmark::RegisterBenchmark("is_occluded", [scene_folder](benchmark::State& state) {
    benchmark_is_occluded(state, scene_folder);
  });
}

const std::vector<const char*>& micro_benchmark_names() {
  static const std::vector<const char*> kNames = [] {
    std::vector<const char*> names;
    for (const Entry& entry : kEntries) names.push_back(entry.name);
    names.insert(names.end(), {"intersect", "is_occluded"});
    return names;
  }();
  return kNames;
}

}  // namespace amalgam::bench
