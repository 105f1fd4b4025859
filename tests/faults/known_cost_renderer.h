// A renderer without pictures, whose frames cost what the test says: milliseconds, as the "JPEG".
#pragma once

#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

#include "frame/view_renderer.h"

namespace amalgam::test {

class KnownCostRenderer : public frame::ViewRenderer {
 public:
  explicit KnownCostRenderer(int world_marker = 40) : world_marker_(world_marker) {}

  std::unique_ptr<State> open(const frame::ViewOptions&) override {
    return std::make_unique<State>();
  }
  frame::FrameOutput render(State&, const frame::FrameInput& input) override {
    const auto& bytes = std::get<frame::Bytes>(input.image);
    const int cost = cost_of(bytes);
    // In tiles of a millisecond. "Stuck" is one long tile.
    for (int i = 0; i < (cost < 0 ? 1 : cost); ++i) {
      input.progress->step();
      std::this_thread::sleep_for(std::chrono::milliseconds(cost < 0 ? -cost : 1));
    }
    frame::FrameOutput output;
    output.jpeg = bytes;
    return output;
  }
  void set_environment(const frame::EnvironmentInput& input) override { spend(input.image); }
  void set_own_environment(State&, const frame::EnvironmentInput& input) override {
    spend(input.image);
  }
  frame::FrameService::MarkerSet markers() const override {
    return {"DICT_6X6_250", 0.05, world_marker_, {world_marker_}};
  }

 private:
  static int cost_of(const frame::Bytes& bytes) {
    return std::stoi(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  }
  // In one piece, as decoding is.
  static void spend(const frame::Bytes& bytes) {
    std::this_thread::sleep_for(std::chrono::milliseconds(std::abs(cost_of(bytes))));
  }

  int world_marker_;
};

inline frame::MakeRenderer known_cost(int world_marker = 40) {
  return [world_marker] { return std::make_unique<KnownCostRenderer>(world_marker); };
}

}  // namespace amalgam::test
