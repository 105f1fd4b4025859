#include "report/determinism.h"

#include <algorithm>

#include "bench/render_rig.h"
#include "report/content_hash.h"

namespace amalgam::report {

std::string layers_hash(const frame::FrameBuffers& buffers) {
  ContentHash hash;
  for (const char* name : {"over", "difference"}) {
    const auto found = buffers.find(name);
    if (found == buffers.end()) continue;
    hash.add(std::string_view(name));
    if (const auto* over = std::get_if<common::ImageRgba32f>(&found->second)) {
      hash.add(std::as_bytes(over->pixels()));
    } else if (const auto* difference = std::get_if<common::ImageRgb32f>(&found->second)) {
      hash.add(std::as_bytes(difference->pixels()));
    }
  }
  return hash.digest();
}

std::vector<LayersHash> measure_determinism(const std::string& scene_name,
                                            const bench::BenchCase& bench_case) {
  std::vector<LayersHash> rows;
  for (const int threads : {1, 2, 3, 16}) {
    frame::RendererSettings settings = bench::default_settings();
    settings.threads = threads;
    bench::RenderRig rig(bench_case, settings);
    frame::FrameBuffers buffers;
    rig.render(bench_case.input, &buffers);
    rows.push_back({scene_name, std::to_string(threads) + (threads == 1 ? " thread" : " threads"),
                    layers_hash(buffers)});
  }
  return rows;
}

bool is_deterministic(const std::vector<LayersHash>& rows) {
  return std::all_of(rows.begin(), rows.end(), [&](const LayersHash& row) {
    const auto first = std::find_if(rows.begin(), rows.end(), [&](const LayersHash& other) {
      return other.scene == row.scene;
    });
    return first->hash == row.hash;
  });
}

}  // namespace amalgam::report
