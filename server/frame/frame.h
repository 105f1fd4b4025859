// Input and output of the renderer for one frame, and the interface that network sessions use.
// Nothing here depends on the renderer.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/camera_model.h"
#include "common/fisheye_model.h"
#include "common/image.h"
#include "common/pose.h"
#include "core/progress.h"
#include "core/provenance.h"
#include "core/ray_counts.h"
#include "core/timings.h"

namespace amalgam::frame {

using Bytes = std::vector<std::byte>;

struct FrameInput {
  // The camera image: the client's JPEG, or pixels that are already decoded.
  std::variant<Bytes, common::ImageRgb8> image;
  std::vector<common::MarkerPose> poses;
  core::Progress* progress = nullptr;  // told how far the frame is; null: nobody asks
};

// One line of the pass list: a pass that ran, or why it was left out.
struct PassRecord {
  std::string name;
  bool ran = false;
  std::string reason;  // empty if it ran
  bool operator==(const PassRecord&) const = default;
};

// Of the rendered image: as large as the camera's, unless the lens distorts or the render scale is
// below 1.
struct PixelCounts {
  std::uint64_t virtual_pixels = 0;
  std::uint64_t specular = 0;
  std::uint64_t refined = 0;  // rendered again with more samples (adaptive sampling)
  std::uint64_t total = 0;
};

// The quality of a frame of a view with a target frame rate (frame/governor.h).
struct FrameQuality {
  // What kept the quality from being better.
  enum class Bound { Nothing, Trace, Raster, Encode, Lowest };

  int level = 0;         // 0: as the operator set it
  int lowest_level = 0;  // the level with the least quality
  int samples_per_pixel = 1;
  bool adaptive = false;  // more samples where neighbours differ
  int max_depth = 0;
  float importance_cutoff = 0.0f;
  float render_scale = 1.0f;  // rendered pixels for each of the camera's, on each axis
  int jpeg_quality = 0;       // 1..100
  Bound bound = Bound::Nothing;
};

inline const char* to_string(FrameQuality::Bound bound) {
  switch (bound) {
    case FrameQuality::Bound::Nothing:
      return "nothing: full quality";
    case FrameQuality::Bound::Trace:
      return "trace";
    case FrameQuality::Bound::Raster:
      return "raster";
    case FrameQuality::Bound::Encode:
      return "encode";
    case FrameQuality::Bound::Lowest:
      return "at its lowest";
  }
  return "";
}

// How far the composite may be from the one with unlimited depth and without a cut-off, in
// display-linear light and before the JPEG (trace/truncation_bound.h says what it does not bound).
struct TruncationBound {
  double mean = 0.0;   // over the rendered image's pixels and channels
  double worst = 0.0;  // of any pixel and channel
};

struct FrameStatistics {
  core::StageTimes stages;
  std::vector<PassRecord> passes;
  core::RayCounts rays;
  PixelCounts pixels;
  std::uint64_t nonfinite = 0;  // values replaced by 0
  TruncationBound truncation_bound;
  glm::vec3 exposure{1.0f};             // of each channel
  std::string tone_curve = "reinhard";  // scene::tone_curve_name()
  std::optional<FrameQuality> quality;  // only with a target frame rate
};

struct FrameOutput {
  Bytes jpeg;              // the composite; the client's own bytes if nothing virtual had an effect
  bool unchanged = false;  // jpeg is the input's, byte for byte
  common::ImageRgb8 pixels;  // the composite, only if ViewOptions::keep_pixels
  // The sources of each pixel's light, in the ideal image; only if ViewOptions::keep_provenance and
  // something was drawn.
  std::optional<core::ProvenanceImage> provenance;
  FrameStatistics statistics;
};

struct ViewOptions {
  common::CameraModel camera;
  // 1..100; 0: the default, and an unaffected frame goes back byte for byte.
  int jpeg_quality = 0;
  bool keep_pixels = false;  // also return the composite as pixels
  bool keep_provenance = false;
};

struct FrameFailure {
  // BadImage: the JPEG is unusable (the client's fault); Internal: ours.
  enum class Kind { BadImage, Internal };
  Kind kind = Kind::Internal;
  std::string what;
};
using FrameResult = std::variant<FrameOutput, FrameFailure>;

using ViewId = std::uint64_t;

// A picture of the scene's surroundings, as a JPEG: low dynamic range.
struct EnvironmentInput {
  Bytes image;
  enum class Projection { Equirectangular, Fisheye } projection = Projection::Equirectangular;
  common::FisheyeModel fisheye{};                     // of a fish-eye image
  glm::dquat world_from_fisheye{1.0, 0.0, 0.0, 0.0};  // unit; the world's axes are glTF's
  std::optional<ViewId> only_for{};  // lights this view alone; none: all that have no own one
};

// How busy the renderer is.
struct ServiceLoad {
  // Part of the renderer's time that all open views ask for: the sum of rate times cost. Above 1
  // not all of their frames can be rendered.
  double demand = 0.0;
  // Seconds for each pixel of a frame, of recent ones; 0: not known yet.
  double seconds_per_pixel = 0.0;
  double frames_per_second = 0.0;          // of an open view, on average
  std::chrono::milliseconds queue_age{0};  // of the frame that has waited longest
  // Since the renderer last showed progress with a frame, or began to apply an environment; 0: it
  // has neither to do.
  std::chrono::milliseconds without_progress{0};
  // Since a new renderer began to be made, which shows no progress and may take long; 0: none is.
  std::chrono::milliseconds reloading{0};
};

// Renders for many views (a view is one client's camera onto the scene). All functions may be
// called from any thread and never block on rendering. At most one frame of a view waits; a newer
// one replaces it.
class FrameService {
 public:
  virtual ~FrameService() = default;

  // Called on the render thread when a frame is done; must be quick and must not throw.
  using Deliver = std::function<void(std::uint64_t ticket, FrameResult result)>;

  // Throws std::invalid_argument if common::describe_defect(options.camera) is not empty.
  virtual ViewId open_view(const ViewOptions& options, Deliver deliver) = 0;

  // Returns true if it replaced a waiting frame, which will never be delivered. The ticket means
  // nothing here; it comes back with the result.
  virtual bool submit(ViewId view, std::uint64_t ticket, FrameInput input) = 0;

  // After this returns, deliver is never called again for the view. A frame of it that is being
  // rendered is cancelled.
  virtual void close_view(ViewId view) = 0;

  // Applies from the next frame on. A view's own one is looked at in that view's turn, with its
  // next frame, so that it takes nobody else's time; it stays when the scene's is replaced or the
  // scene reloaded, and goes with the view. done is called on the render thread, with an error text
  // or nothing; it must be quick and must not throw. It is not called for a view that is closed.
  virtual void set_environment(EnvironmentInput input,
                               std::function<void(std::optional<std::string> error)> done) = 0;

  // Bytes that a view keeps of such an own environment. Known by its header; 0 if it is unusable.
  virtual std::uint64_t memory_of(const EnvironmentInput&) const { return 0; }

  // Markers that a client should look for: the scene's, world marker first.
  struct MarkerSet {
    std::string dictionary;
    double marker_length = 0.0;  // metres
    int world_marker = 0;
    std::vector<int> ids;
    bool operator==(const MarkerSet&) const = default;
  };
  virtual MarkerSet markers() const = 0;

  // What decides a composite's bytes besides what its client sends, as texts for people. Where all
  // are equal, so are the bytes, unless the options have a target frame rate.
  struct Fingerprint {
    std::string scene;       // its file's name
    std::string scene_hash;  // SHA-256 of its files
    std::string options;     // the renderer's that differ from the defaults
    std::string hardware;    // what OpenGL and the ray tracer run on
    bool operator==(const Fingerprint&) const = default;
  };
  virtual Fingerprint fingerprint() const { return {}; }

  virtual ServiceLoad load() const { return {}; }
};

}  // namespace amalgam::frame
