#include "net/metrics.h"

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>

#include <cctype>
#include <string_view>

#include "common/build_info.h"
#include "net/process_figures.h"

namespace amalgam::net {
namespace {

using prometheus::Counter;
using prometheus::Family;
using prometheus::Gauge;
using prometheus::Histogram;

// From well below a display's frame to where a viewer gives up, seconds.
const Histogram::BucketBoundaries kSeconds{0.0005, 0.001, 0.002, 0.004, 0.008, 0.016, 0.033,
                                           0.066,  0.125, 0.25,  0.5,   1.0,   2.0,   5.0};
const Histogram::BucketBoundaries kFractions{0.0, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0};

const Histogram::BucketBoundaries kLevels{0.0, 1.0,  2.0,  3.0,  4.0,  6.0,
                                          8.0, 12.0, 16.0, 24.0, 32.0, 48.0};

// Of the refusals that there can be, so that all are there from the start.
constexpr const char* kRefusals[] = {"connections", "unauthenticated", "address", "back_off",
                                     "load",        "memory"};

constexpr const char* kFates[] = {"applied",   "replaced",  "unusable",
                                  "forbidden", "too_often", "no_memory"};

// Names for people as values of labels: lower case, and what is no letter or digit becomes a _.
std::string label_of(std::string_view name) {
  std::string label;
  for (const char c : name) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (letter) {
      label += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!label.empty() && label.back() != '_') {
      label += '_';
    }
  }
  return label;
}

// Of something that is counted elsewhere.
void rise_to(Counter& counter, double value) {
  if (value > counter.Value()) counter.Increment(value - counter.Value());
}

}  // namespace

const char* to_string(Skip reason) {
  switch (reason) {
    case Skip::ReplacedBeforeRender:
      return "replaced_before_render";
    case Skip::ReplacedBeforeWrite:
      return "replaced_before_write";
    case Skip::Refused:
      return "refused";
    case Skip::Draining:
      return "draining";
    case Skip::Closed:
      return "closed";
  }
  return "";
}

struct Metrics::Families {
  prometheus::Registry registry;

  Family<Counter>& counter(const std::string& name, const std::string& help) {
    return prometheus::BuildCounter().Name(name).Help(help).Register(registry);
  }
  Family<Histogram>& histogram(const std::string& name, const std::string& help) {
    return prometheus::BuildHistogram().Name(name).Help(help).Register(registry);
  }

  Family<Histogram>& stages =
      histogram("amalgam_stage_seconds", "Time of one stage of a frame, by stage");
  Histogram& render_time =
      histogram("amalgam_render_seconds", "Time of all stages of a frame together")
          .Add({}, kSeconds);
  Histogram& server_time =
      histogram("amalgam_frame_seconds", "From a frame's last byte to its composite, with waiting")
          .Add({}, kSeconds);
  Histogram& coverage =
      histogram("amalgam_mask_coverage_ratio", "Part of the pixels that something virtual covers")
          .Add({}, kFractions);
  Counter& frames_in = counter("amalgam_frames_received_total", "Camera frames received").Add({});
  Counter& frames_out = counter("amalgam_frames_sent_total", "Composites written").Add({});
  Family<Counter>& skipped =
      counter("amalgam_frames_skipped_total", "Frames never answered by a composite, by reason");
  Counter& unchanged =
      counter("amalgam_frames_unchanged_total", "Frames on which nothing virtual had an effect")
          .Add({});
  Counter& bytes_in =
      counter("amalgam_frame_bytes_received_total", "Bytes of camera frame messages").Add({});
  Counter& bytes_out =
      counter("amalgam_composite_bytes_sent_total", "Bytes of composite messages").Add({});
  Gauge& gauge(const std::string& name, const std::string& help) {
    return prometheus::BuildGauge().Name(name).Help(help).Register(registry).Add({});
  }
  Gauge& sessions = gauge("amalgam_sessions", "Sessions past their hello");
  Gauge& connections = gauge("amalgam_connections", "Connections of clients");
  Gauge& unauthenticated =
      gauge("amalgam_connections_unauthenticated", "Connections without a hello so far");
  Gauge& queue_age =
      gauge("amalgam_queue_age_seconds", "Of the frame that has waited longest for its turn");
  Gauge& demand = gauge("amalgam_demand_ratio",
                        "Part of the renderer's time that sessions ask for: rate times cost");
  Gauge& without_progress = gauge("amalgam_render_stalled_seconds",
                                  "Since the renderer last showed progress with a frame");
  Gauge& session_memory =
      gauge("amalgam_session_memory_bytes", "Memory that sessions were admitted for");
  Counter& cpu = counter("process_cpu_seconds_total", "CPU time, user and system").Add({});
  Gauge& memory = gauge("process_resident_memory_bytes", "Resident memory");
  Gauge& descriptors = gauge("process_open_fds", "Open descriptors");
  Counter& dropped_lines =
      counter("amalgam_log_lines_dropped_total", "Log lines that nobody read in time").Add({});
  Counter& record_bytes =
      counter("amalgam_record_bytes_total", "Bytes written to records of sessions").Add({});
  Family<Counter>& records = counter("amalgam_records_ended_total",
                                     "Records of sessions that ended before them, by reason");
  Counter& full_records = records.Add({{"reason", "full"}});
  Counter& slow_records = records.Add({{"reason", "too_slow"}});
  Counter& failed_records = records.Add({{"reason", "failed"}});
  Family<Counter>& environments =
      counter("amalgam_environments_total", "Environments sent by clients, by what became of them");
  Family<Counter>& reloads =
      counter("amalgam_reloads_total", "Reloads of scene and configuration, by result");
  Family<Counter>& connected =
      counter("amalgam_connections_accepted_total", "Connections of clients, by transport");
  Family<Counter>& refusals =
      counter("amalgam_refusals_total", "Connections and sessions refused, by reason");
  Family<Counter>& errors =
      counter("amalgam_errors_total",
              "Mistakes of clients and failures, by code; a client that is gone or does not read "
              "never learns of its own");
  Counter& clamped =
      counter("amalgam_capture_times_clamped_total", "Capture times backwards or far ahead")
          .Add({});
  Counter& bad_poses =
      counter("amalgam_poses_rejected_total", "Poses that could not be rendered with").Add({});
  Family<Counter>& rays = counter(
      "amalgam_rays_total", "Rays traced, by kind; reused: not traced, because nothing had moved");
  Family<Counter>& passes = counter("amalgam_passes_run_total", "Passes run, by pass");
  Family<Histogram>& quality = histogram(
      "amalgam_quality_level", "Level that a frame was rendered at, 0 is full quality, by bound");
  Counter& nonfinite =
      counter("amalgam_nonfinite_total", "Values that a stage had to replace by 0").Add({});
};

Metrics::Metrics() : families_(std::make_unique<Families>()) {
  // Counters that are there from the start, at 0, can be watched for their first increment.
  for (const Skip reason : kSkips) families_->skipped.Add({{"reason", to_string(reason)}});
  using protocol::Error;
  for (int code = Error::Code_MIN + 1; code <= Error::Code_MAX; ++code) {
    families_->errors.Add({{"code", Error::Code_Name(static_cast<Error::Code>(code))}});
  }
  for (const char* reason : kRefusals) families_->refusals.Add({{"reason", reason}});
  for (const char* fate : kFates) families_->environments.Add({{"result", fate}});
  for (const char* result : {"done", "kept_the_old"}) families_->reloads.Add({{"result", result}});
  prometheus::BuildGauge()
      .Name("amalgam_build_info")
      .Help("Always 1; the labels tell which server this is")
      .Register(families_->registry)
      .Add({{"version", common::version()}, {"instruction_set", common::instruction_set()}})
      .Set(1.0);
}
Metrics::~Metrics() = default;

void Metrics::connected(const std::string& transport) {
  families_->connected.Add({{"transport", transport}}).Increment();
}
void Metrics::session_opened() {
  families_->sessions.Increment();
}
void Metrics::session_closed() {
  families_->sessions.Decrement();
}
void Metrics::refused(const std::string& reason) {
  families_->refusals.Add({{"reason", reason}}).Increment();
}
void Metrics::error_sent(protocol::Error::Code code) {
  families_->errors.Add({{"code", protocol::Error::Code_Name(code)}}).Increment();
}
void Metrics::capture_time_clamped() {
  families_->clamped.Increment();
}
void Metrics::pose_held_or_dropped(std::size_t count) {
  families_->bad_poses.Increment(static_cast<double>(count));
}

void Metrics::frame_received(std::size_t message_bytes) {
  families_->frames_in.Increment();
  families_->bytes_in.Increment(static_cast<double>(message_bytes));
}

void Metrics::frame_skipped(Skip reason, std::size_t count) {
  families_->skipped.Add({{"reason", to_string(reason)}}).Increment(static_cast<double>(count));
}

void Metrics::frame_rendered(const frame::FrameOutput& output, double server_ms) {
  const frame::FrameStatistics& statistics = output.statistics;
  for (const core::StageTime& time : statistics.stages) {
    const double seconds = time.milliseconds / 1000.0;
    if (time.stage == "total") {
      families_->render_time.Observe(seconds);  // a sum is no part of itself
    } else {
      families_->stages.Add({{"stage", label_of(time.stage)}}, kSeconds).Observe(seconds);
    }
  }
  families_->server_time.Observe(server_ms / 1000.0);
  if (statistics.pixels.total > 0) {
    families_->coverage.Observe(static_cast<double>(statistics.pixels.virtual_pixels) /
                                static_cast<double>(statistics.pixels.total));
  }
  if (output.unchanged) families_->unchanged.Increment();
  const auto count_rays = [&](const char* kind, std::uint64_t count) {
    families_->rays.Add({{"kind", kind}}).Increment(static_cast<double>(count));
  };
  count_rays("primary", statistics.rays.primary);
  count_rays("reflection", statistics.rays.reflection);
  count_rays("refraction", statistics.rays.refraction);
  count_rays("shadow", statistics.rays.shadow);
  count_rays("lookup", statistics.rays.lookup);
  count_rays("reused", statistics.rays.reused);
  for (const frame::PassRecord& pass : statistics.passes) {
    if (pass.ran) families_->passes.Add({{"pass", label_of(pass.name)}}).Increment();
  }
  if (const auto& quality = statistics.quality) {
    families_->quality.Add({{"bound", label_of(to_string(quality->bound))}}, kLevels)
        .Observe(quality->level);
  }
  families_->nonfinite.Increment(static_cast<double>(statistics.nonfinite));
}

void Metrics::composite_sent(std::size_t message_bytes) {
  families_->frames_out.Increment();
  families_->bytes_out.Increment(static_cast<double>(message_bytes));
}

void Metrics::environment(EnvironmentFate fate) {
  families_->environments.Add({{"result", kFates[static_cast<std::size_t>(fate)]}}).Increment();
}

void Metrics::reloaded(bool good) {
  families_->reloads.Add({{"result", good ? "done" : "kept_the_old"}}).Increment();
}

std::string Metrics::text(const Gauges& gauges) {
  const auto seconds = [](std::chrono::milliseconds time) {
    return std::chrono::duration<double>(time).count();
  };
  families_->connections.Set(static_cast<double>(gauges.connections));
  families_->unauthenticated.Set(static_cast<double>(gauges.unauthenticated));
  families_->queue_age.Set(seconds(gauges.load.queue_age));
  families_->demand.Set(gauges.load.demand);
  families_->without_progress.Set(seconds(gauges.load.without_progress));
  families_->session_memory.Set(static_cast<double>(gauges.session_memory));
  rise_to(families_->dropped_lines, static_cast<double>(gauges.dropped_log_lines));
  rise_to(families_->record_bytes, static_cast<double>(gauges.records.bytes));
  rise_to(families_->full_records, static_cast<double>(gauges.records.full));
  rise_to(families_->slow_records, static_cast<double>(gauges.records.too_slow));
  rise_to(families_->failed_records, static_cast<double>(gauges.records.failed));
  const ProcessFigures process = read_process_figures();
  rise_to(families_->cpu, process.cpu_seconds);
  families_->memory.Set(static_cast<double>(process.resident_bytes));
  families_->descriptors.Set(static_cast<double>(process.open_descriptors));
  return prometheus::TextSerializer().Serialize(families_->registry.Collect());
}

}  // namespace amalgam::net
