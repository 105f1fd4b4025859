// numerics B25: the same bits for any number of threads, in everything that a frame computes, and
// from one frame to the next.
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <string_view>

#include "numerics/isa.h"
#include "parity/everything_case.h"
#include "parity/rendering.h"

namespace amalgam::parity {
namespace {

template <typename Pixel>
std::size_t hash_of(const common::Image<Pixel>& image) {
  const auto* bytes = reinterpret_cast<const char*>(image.pixels().data());
  return std::hash<std::string_view>()({bytes, image.pixels().size() * sizeof(Pixel)});
}

std::size_t hash_of(const frame::Channels& channels) {
  std::size_t hash = 0;
  for (const auto& [name, image] : channels) hash = 31 * hash + hash_of(image);
  return hash;
}

// By the buffers' names, and the composite.
std::map<std::string, std::size_t> hashes(const Rendering& rendering) {
  std::map<std::string, std::size_t> result{{"composite", hash_of(rendering.composite)}};
  for (const auto& [name, buffer] : rendering.buffers) {
    result[name] = std::visit([](const auto& image) { return hash_of(image); }, buffer);
  }
  return result;
}

frame::RendererSettings settings_of(frame::RendererMode mode, int threads) {
  frame::RendererSettings settings;
  settings.mode = mode;
  settings.threads = threads;
  return settings;
}

TEST(Threads, EveryBufferHasTheSameBitsForAnyNumber) {
  const ParityCase everything = with_samples(make_everything_case(), 2);
  for (const auto mode : {frame::RendererMode::Hybrid, frame::RendererMode::Raytrace}) {
    const auto one = hashes(render(everything, settings_of(mode, 1)));
    EXPECT_TRUE(one.contains("over") && one.contains("difference") && one.contains("mixed"));
    for (const int threads : {2, 3, 16, 64}) {
      EXPECT_EQ(hashes(render(everything, settings_of(mode, threads))), one)
          << mode_name(mode) << " " << threads;
    }
  }
}

TEST(Threads, EveryInstructionSetIsDeterministic) {
  const ParityCase everything = make_everything_case();
  for (const std::string& isa : trace::usable_isas()) {
    const test_support::ChosenIsa chosen(isa);
    const auto one = hashes(render(everything, settings_of(frame::RendererMode::Raytrace, 1)));
    EXPECT_EQ(hashes(render(everything, settings_of(frame::RendererMode::Raytrace, 3))), one)
        << isa;
  }
}

}  // namespace
}  // namespace amalgam::parity
