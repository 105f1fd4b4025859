// The benchmarks themselves; times are for one call, items for one pixel or ray.
#pragma once

#include <benchmark/benchmark.h>

#include <filesystem>

namespace amalgam::bench {

void benchmark_fresnel_schlick(benchmark::State& state);
void benchmark_fresnel_exact(benchmark::State& state);
void benchmark_refract(benchmark::State& state);
void benchmark_tone_map(benchmark::State& state);
void benchmark_srgb_encode(benchmark::State& state);
void benchmark_sample_environment(benchmark::State& state);
void benchmark_composite(benchmark::State& state);
void benchmark_decode(benchmark::State& state);
void benchmark_encode(benchmark::State& state);
void benchmark_bright_frame(benchmark::State& state);
void benchmark_denormal_frame(benchmark::State& state);
void benchmark_intersect(benchmark::State& state, const std::filesystem::path& scene_folder);
void benchmark_is_occluded(benchmark::State& state, const std::filesystem::path& scene_folder);

}  // namespace amalgam::bench
