// The client's loop: captures, finds markers, sends frames and hands composites to the sink.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "client/link/connection.h"
#include "client/link/frames_in_flight.h"
#include "client/sinks/frame_sink.h"
#include "client/sources/camera_source.h"
#include "client/tracking/marker_tracker.h"
#include "client/tracking/pose_dead_band.h"
#include "tracking/marker_board.h"
#include "tracking/pose_smoother.h"

namespace amalgam::client {

struct ViewerOptions {
  std::uint64_t frames = 0;  // to capture; 0: until the source ends
  double rate = 30.0;        // frames a second, for sources that are not live
  bool lockstep = false;     // wait for the answer to each frame before the next
  std::optional<tracking::MarkerBoard> board{};         // see TrackerOptions
  std::optional<tracking::OneEuroOptions> smoothing{};  // of all poses that are sent
  double dead_band = 0.0;                               // pixels, after smoothing; 0: none
};

struct ViewerSummary {
  FrameCounts frames;
  LatencySummary latency;  // milliseconds
  tracking::TrackerCounts markers;
  std::optional<tracking::SmoothingReport> smoothing;
  std::uint64_t poses_held = 0;  // sent again by the dead band
  std::uint64_t reconnects = 0;
  std::uint64_t server_errors = 0;             // Errors that the session survived
  std::string last_error;                      // the last of these, or why the connection gave up
  std::vector<common::MarkerPose> last_poses;  // of the last frame in which there were any
  bool gave_up = false;                        // the connection gave up before all frames were done
  double seconds = 0.0;                        // from the first capture to the end
};

class Viewer {
 public:
  // sink may be null. stop is set from outside (a signal) to end early.
  Viewer(const ViewerOptions& options, const common::CameraModel& camera, CameraSource& source,
         FrameSink* sink, Connection& connection, const std::atomic<bool>& stop);

  // Runs once, until all frames are captured and accounted for, the user stops it, or the
  // connection gives up. Throws std::runtime_error for a server that names no dictionary of
  // OpenCV's.
  ViewerSummary run();

 private:
  using Clock = std::chrono::steady_clock;

  bool wait_for_welcome();
  void stream();
  void finish();
  void send(const CapturedFrame& frame);
  void add_counts();  // of the tracker and the dead band that end now, to the summary
  bool handle_next(std::chrono::milliseconds timeout);  // false: no event in that time
  void handle(Welcomed& event);
  void handle(Composited& event);
  void handle(FrameError& event);
  void handle(LinkBroken& event);
  void handle(GaveUp& event);
  bool is_stopped() const { return stop_ || stopped_by_user_ || summary_.gave_up; }

  const ViewerOptions options_;
  const common::CameraModel camera_;
  CameraSource& source_;
  FrameSink* sink_;
  Connection& connection_;
  const std::atomic<bool>& stop_;
  std::optional<MarkerTracker> tracker_;  // made when the server has sent its markers
  std::string markers_;                   // those markers, as received
  std::optional<tracking::PoseSmoother> smoother_;
  std::optional<PoseDeadBand> dead_band_;  // made with the tracker
  FramesInFlight in_flight_;
  ViewerSummary summary_;
  std::uint64_t last_id_ = 0;
  bool stopped_by_user_ = false;
};

}  // namespace amalgam::client
