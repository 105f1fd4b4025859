// numerics B25: the same bits for any number of threads, in everything that a frame computes, and
// from one frame to the next.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <map>
#include <string_view>
#include <thread>

#include "numerics/isa.h"
#include "numerics/many_workers.h"
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

TEST(Threads, ManyMoreThanCoresDoRun) {
  const test_support::ManyWorkers many;
  tbb::task_arena arena(16);
  std::atomic<int> inside = 0, most = 0;
  arena.execute([&] {
    tbb::parallel_for(
        0, 64,
        [&](int) {
          const int now = ++inside;
          for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
          }
          std::this_thread::sleep_for(std::chrono::milliseconds(5));
          --inside;
        },
        tbb::simple_partitioner());
  });
  EXPECT_GT(most, 8);
}

void expect_same_bits(frame::RendererMode mode, std::initializer_list<int> numbers) {
  const test_support::ManyWorkers many;
  const ParityCase everything = make_everything_case();
  const auto one = hashes(render(everything, settings_of(mode, 1)));
  EXPECT_TRUE(one.contains("over") && one.contains("difference") && one.contains("mixed"));
  for (const int threads : numbers) {
    EXPECT_EQ(hashes(render(everything, settings_of(mode, threads))), one) << threads;
  }
}

TEST(Threads, AnyNumberGivesTheSameBitsOfEveryBuffer) {
  expect_same_bits(frame::RendererMode::Hybrid, {3, 16});
}

TEST(Threads, AnyNumberGivesTheSameBitsWhenAllIsTraced) {
  expect_same_bits(frame::RendererMode::Raytrace, {2, 3, 16, 64});
}

TEST(Threads, EveryInstructionSetIsDeterministic) {
  const test_support::ManyWorkers many;
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
