// Functions that are called for each ray or sample.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "bench/micro/benchmarks.h"
#include "scene/light/environment.h"
#include "scene/light/tone_map.h"
#include "trace/fresnel.h"

namespace amalgam::bench {
namespace {

constexpr std::size_t kInputs = 1024;  // a power of two: they are gone through again and again

// In (0, 1), without order, the same in every run.
double scattered(std::size_t i) {
  constexpr double kGolden = 0.6180339887498949;
  return std::fmod(kGolden * static_cast<double>(i + 1), 1.0);
}

template <typename Value, typename Make>
std::array<Value, kInputs> make_inputs(const Make& make) {
  std::array<Value, kInputs> inputs{};
  for (std::size_t i = 0; i < kInputs; ++i) inputs[i] = make(i);
  return inputs;
}

glm::dvec3 scattered_direction(std::size_t i) {
  const double z = 2.0 * scattered(i) - 1.0, turn = 6.283185307 * scattered(7 * i + 3);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

template <typename Inputs, typename Call>
void call_again_and_again(benchmark::State& state, const Inputs& inputs, const Call& call) {
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(call(inputs[i++ % kInputs]));
  state.SetItemsProcessed(state.iterations());
}

}  // namespace

void benchmark_fresnel_schlick(benchmark::State& state) {
  call_again_and_again(state, make_inputs<double>(scattered),
                       [](double cosine) { return trace::reflectance_schlick(cosine, 1.5, 1.0); });
}

void benchmark_fresnel_exact(benchmark::State& state) {
  call_again_and_again(state, make_inputs<double>(scattered),
                       [](double cosine) { return trace::reflectance_exact(cosine, 1.5, 1.0); });
}

void benchmark_refract(benchmark::State& state) {
  const glm::dvec3 normal(0.0, 0.0, 1.0);
  const auto inputs = make_inputs<glm::dvec3>([](std::size_t i) {
    glm::dvec3 direction = scattered_direction(i);
    direction.z = -std::abs(direction.z);
    return direction;
  });
  call_again_and_again(state, inputs, [&](const glm::dvec3& direction) {
    return trace::refract(direction, normal, 1.0, 1.5);
  });
}

void benchmark_tone_map(benchmark::State& state) {
  const auto inputs = make_inputs<glm::vec3>([](std::size_t i) {
    return glm::vec3(scattered(i), scattered(3 * i), scattered(5 * i)) * 4.0f;
  });
  call_again_and_again(state, inputs, [](const glm::vec3& light) {
    return scene::tone_map(light, scene::tone_map_of(0.8f));
  });
}

void benchmark_srgb_encode(benchmark::State& state) {
  const auto inputs = make_inputs<glm::vec3>(
      [](std::size_t i) { return glm::vec3(scattered(i), scattered(3 * i), scattered(5 * i)); });
  call_again_and_again(state, inputs,
                       [](const glm::vec3& light) { return scene::srgb_encode(light); });
}

void benchmark_sample_environment(benchmark::State& state) {
  const scene::Environment environment{common::ImageRgb32f(512, 256, glm::vec3(0.5f)), false};
  const auto inputs =
      make_inputs<glm::vec3>([](std::size_t i) { return glm::vec3(scattered_direction(i)); });
  call_again_and_again(state, inputs, [&](const glm::vec3& direction) {
    return scene::sample_environment(environment, direction);
  });
}

}  // namespace amalgam::bench
