// Google Benchmarks of hot functions.
#pragma once

#include <benchmark/benchmark.h>

#include <filesystem>
#include <vector>

namespace amalgam::bench {

// Registers all of them with the library. Scenes come from the folder; without the bunny a sphere
// is intersected.
void register_micro_benchmarks(const std::filesystem::path& scene_folder);

// As registered.
const std::vector<const char*>& micro_benchmark_names();

}  // namespace amalgam::bench
