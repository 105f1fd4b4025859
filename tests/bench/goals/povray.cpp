// The whole server path against POV-Ray, an offline ray tracer, for the same scene.
#include "bench/goals/measures.h"
#include "bench/povray/pov_run.h"
#include "bench/povray/pov_scene.h"
#include "bench/povray/temporary_folder.h"
#include "bench/render_rig.h"
#include "bench/scene_server.h"
#include "bench/session.h"

namespace amalgam::bench {

Outcome measure_povray(GoalBench& bench) {
  if (!has_povray()) return NotMeasured{"no povray here: apt-get install povray"};
  const BenchCase bunny = bench.scenes().glass_bunny(1280, 1024);
  const frame::RendererSettings settings = default_settings();
  const TemporaryFolder folder;
  const auto scene = write_pov_scene(bunny, settings.trace, folder.path());
  SceneServer server(bunny.scene_path, settings);
  Session session(server.address(), bunny);
  session.round_trip_milliseconds();
  const auto povray = [&] {
    return povray_trace_milliseconds(scene, folder.path() / "picture.png", bunny.camera.width,
                                     bunny.camera.height, bench.cores());
  };
  const Ratio ratio = measure_by_turns(
      {.least = 2, .most = 3, .seconds = 20.0}, [&] { return session.round_trip_milliseconds(); },
      povray);
  return to_measurement(ratio, bunny.name + ": " + describe(ratio) + ", POV-Ray " +
                                   povray_version() + ", depth and cut-off as ours");
}

}  // namespace amalgam::bench
