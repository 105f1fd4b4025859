#include "report/determinism.h"

#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>
#include <optional>
#include <type_traits>

#include "bench/render_rig.h"
#include "report/content_hash.h"
#include "trace/embree_isa.h"

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

namespace {

frame::FrameBuffers render_buffers(const bench::BenchCase& bench_case, int threads) {
  frame::RendererSettings settings = bench::default_settings();
  settings.threads = threads;
  bench::RenderRig rig(bench_case, settings);
  frame::FrameBuffers buffers;
  rig.render(bench_case.input, &buffers);
  return buffers;
}

// Sets Embree's instruction set for renderers that are made in its lifetime.
class ChosenIsa {
 public:
  explicit ChosenIsa(const std::string& isa) {
    if (const char* before = std::getenv(trace::kIsaVariable)) before_ = before;
    setenv(trace::kIsaVariable, isa.c_str(), 1);
  }
  ~ChosenIsa() {
    if (before_) {
      setenv(trace::kIsaVariable, before_->c_str(), 1);
    } else {
      unsetenv(trace::kIsaVariable);
    }
  }
  ChosenIsa(const ChosenIsa&) = delete;
  ChosenIsa& operator=(const ChosenIsa&) = delete;

 private:
  std::optional<std::string> before_;
};

template <typename Pixel>
void compare(const common::Image<Pixel>& a, const common::Image<Pixel>& b,
             std::vector<std::uint8_t>& differs, double& largest) {
  differs.resize(std::max(differs.size(), a.pixels().size()));
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Pixel distance = glm::abs(a.pixels()[i] - b.pixels()[i]);
    for (int c = 0; c < Pixel::length(); ++c) {
      if (distance[c] > 0.0f) differs[i] = 1;
      largest = std::max(largest, static_cast<double>(distance[c]));
    }
  }
}

// How far the layers are from those of the first row.
void set_difference(LayersHash& row, const frame::FrameBuffers& first,
                    const frame::FrameBuffers& other) {
  std::vector<std::uint8_t> differs;
  for (const char* name : {"over", "difference"}) {
    const auto a = first.find(name), b = other.find(name);
    if (a == first.end() || b == other.end()) continue;
    std::visit(
        [&](const auto& image) {
          using Image = std::decay_t<decltype(image)>;
          if constexpr (std::is_same_v<Image, common::ImageRgba32f> ||
                        std::is_same_v<Image, common::ImageRgb32f>) {
            compare(image, std::get<Image>(b->second), differs, row.largest_difference);
          }
        },
        a->second);
  }
  row.differing_pixels = std::count(differs.begin(), differs.end(), 1);
}

}  // namespace

std::vector<LayersHash> measure_determinism(const std::string& scene_name,
                                            const bench::BenchCase& bench_case) {
  std::vector<LayersHash> rows;
  const frame::FrameBuffers first = render_buffers(bench_case, 1);
  const auto add = [&](const std::string& what, const frame::FrameBuffers& buffers) {
    LayersHash& row = rows.emplace_back();
    row.scene = scene_name;
    row.what = what;
    row.hash = layers_hash(buffers);
    set_difference(row, first, buffers);
  };
  add("1 thread", first);
  for (const int threads : {2, 3, 16}) {
    add(std::to_string(threads) + " threads", render_buffers(bench_case, threads));
  }
  for (const std::string& isa : trace::usable_isas()) {
    const ChosenIsa chosen(isa);
    add(isa, render_buffers(bench_case, 2));
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
