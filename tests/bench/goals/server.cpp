// The whole way of a frame through the server, and of two clients' frames.
#include <future>

#include "bench/goals/measures.h"
#include "bench/render_rig.h"
#include "bench/scene_server.h"
#include "bench/session.h"
#include "bench/stage_sums.h"

namespace amalgam::bench {
namespace {

constexpr double kSecondsOfStream = 2.0;

// The two rates while both clients stream, as shares of what each gets alone.
double shares_together(Session& one, Session& two, double one_alone, double two_alone) {
  auto other =
      std::async(std::launch::async, [&] { return two.frames_per_second(kSecondsOfStream); });
  const double first = one.frames_per_second(kSecondsOfStream);
  return first / one_alone + other.get() / two_alone;
}

}  // namespace

Outcome measure_server_path(GoalBench& bench) {
  const BenchCase bunny = bench.scenes().glass_bunny(1280, 1024);
  SceneServer server(bunny.scene_path, default_settings());
  Session session(server.address(), bunny);
  session.round_trip_milliseconds();
  RenderRig rig(bunny, default_settings());
  const Ratio ratio = measure_by_turns(
      {}, [&] { return session.round_trip_milliseconds(); },
      [&] { return sum_of_stages(rig.render().statistics.stages); });
  return to_measurement(ratio, bunny.name + ", loopback: " + describe(ratio));
}

Outcome measure_two_clients(GoalBench& bench) {
  if (bench.cores() < 2) return NotMeasured{"this machine has one core"};
  const BenchCase bunny = bench.scenes().mirror_bunny(800, 600);
  const BenchCase complex = bench.scenes().complex(800, 600);
  SceneServer bunny_server(bunny.scene_path, default_settings());
  SceneServer complex_server(complex.scene_path, default_settings());
  Session one(bunny_server.address(), bunny), two(complex_server.address(), complex);
  one.round_trip_milliseconds();
  two.round_trip_milliseconds();
  std::vector<double> together, alone;
  for (int round = 0; round < 3; ++round) {
    const double one_alone = one.frames_per_second(kSecondsOfStream);
    const double two_alone = two.frames_per_second(kSecondsOfStream);
    together.push_back(shares_together(one, two, one_alone, two_alone));
    alone.push_back(1.0);
  }
  const Ratio ratio = ratio_of_rounds(together, alone);
  return to_measurement(ratio, bunny.name + " and " + complex.name +
                                   ": sum of what each gets of its own rate, 3 rounds");
}

}  // namespace amalgam::bench
