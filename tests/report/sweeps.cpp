#include "report/sweeps.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "bench/render_rig.h"
#include "frame/settings_options.h"

namespace amalgam::report {
namespace {

using Settings = frame::RendererSettings;

constexpr std::array kSharesBetweenMirrors{0.1, 0.05, 0.025, 0.012, 0.006};

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

int side_of(int samples) {
  return static_cast<int>(std::lround(std::sqrt(samples)));
}

// The reference that has the point's own model, depth and samples.
ReferenceSpec same_as(const Settings& settings) {
  ReferenceSpec spec;
  spec.samples_per_side = side_of(settings.samples_per_pixel);
  spec.max_depth = settings.trace.max_depth;
  spec.importance_cutoff = static_cast<double>(settings.trace.importance_cutoff);
  spec.exact_fresnel = settings.trace.fresnel == trace::FresnelModel::Exact;
  spec.env_lights = settings.env_lights;
  return spec;
}

class Sweeps {
 public:
  explicit Sweeps(const SweepOptions& options)
      : quick_(options.quick), quality_(options.quick ? quick_quality() : full_quality()) {
    base_ = bench::default_settings();
    base_.exposure = options.exposure;
    if (options.threads > 0) base_.threads = options.threads;
    stiff_ = options.stiff;
    // All of what is stiff is traced anyway, and this needs no OpenGL context for each setting.
    if (stiff_) base_.mode = frame::RendererMode::Raytrace;
    reflectance_ = options.bounce_reflectance;
  }

  std::vector<SweepPoint> all() {
    if (reflectance_) {
      depth_between_mirrors(*reflectance_);
      cutoff_between_mirrors(*reflectance_);
      return std::move(points_);
    }
    if (stiff_) {
      depth();
      cutoff();
      return std::move(points_);
    }
    samples();
    adaptive();
    depth();
    cutoff();
    lights();
    fresnel();
    shadow_edges();
    jpeg();
    render_scale();
    joint();
    return std::move(points_);
  }

 private:
  SweepPoint& add(const std::string& sweep, const std::string& label, double value,
                  const Settings& settings) {
    points_.push_back({.sweep = sweep,
                       .label = label,
                       .value = value,
                       .settings = settings,
                       .reference = best_reference(quality_),
                       .limit = std::nullopt});
    return points_.back();
  }

  template <typename Value>
  std::vector<Value> levels(std::vector<Value> quick, std::vector<Value> full) const {
    return quick_ ? quick : full;
  }

  void samples() {
    for (const int count : {1, 4, 9, 16}) {
      Settings settings = base_;
      settings.samples_per_pixel = count;
      SweepPoint& point = add("samples", std::to_string(count), count, settings);
      point.limit = same_as(settings);
      point.limit->samples_per_side = quality_.samples_per_side;
    }
  }

  void adaptive() {
    add("adaptive", "off", kNoNumber, base_);
    for (const float threshold : levels<float>({0.1f, 0.03f}, {0.3f, 0.1f, 0.03f, 0.01f, 0.003f})) {
      Settings settings = base_;
      settings.adaptive_threshold = threshold;
      add("adaptive", frame::exact_text(threshold), static_cast<double>(threshold), settings);
    }
  }

  // The cut-off would end most branches before the depth does: it is lowered here.
  void depth() {
    for (const int depth : levels<int>({1, 2, 4, 6, 10}, {1, 2, 3, 4, 6, 8, 10, 16, 24, 32})) {
      Settings settings = base_;
      settings.trace.max_depth = depth;
      settings.trace.importance_cutoff = 0.004f;
      SweepPoint& point = add("depth", std::to_string(depth), depth, settings);
      point.limit = same_as(settings);
      point.limit->max_depth = quality_.max_depth;
    }
  }

  // Depths at which the error has fallen to these shares: so small that the tone curve is straight
  // over it. They are even, so that all rays are cut off looking the same way.
  void depth_between_mirrors(double r) {
    for (const double share : kSharesBetweenMirrors) {
      const int depth = 2 * static_cast<int>(std::ceil(0.5 * std::log(share) / std::log(r)));
      Settings settings = base_;
      settings.trace.max_depth = depth;
      settings.trace.importance_cutoff = static_cast<float>(quality_.limit_cutoff);
      add_between_mirrors("depth", std::to_string(depth), depth, settings);
    }
  }

  // Cut-offs between the weights of two bounces, so that rounding does not decide.
  void cutoff_between_mirrors(double r) {
    for (const double share : kSharesBetweenMirrors) {
      const double bounces = 2.0 * std::ceil(0.5 * std::log(share) / std::log(r)) + 0.5;
      Settings settings = base_;
      settings.trace.max_depth = kDeepest;
      // Three digits, for labels that can be read.
      char text[16];
      std::snprintf(text, sizeof text, "%.3g", std::pow(r, bounces));
      settings.trace.importance_cutoff = std::stof(text);
      const auto cutoff = static_cast<double>(settings.trace.importance_cutoff);
      add_between_mirrors("cut-off", frame::exact_text(settings.trace.importance_cutoff), cutoff,
                          settings);
    }
  }

  void add_between_mirrors(const char* sweep, const std::string& label, double value,
                           const Settings& settings) {
    SweepPoint& point = add(sweep, label, value, settings);
    // One ray tells as much as many: all that matters is how far it is followed.
    point.reference = same_as(settings);
    point.reference.max_depth = kDeepest;
    point.reference.importance_cutoff = quality_.limit_cutoff;
    point.limit = point.reference;
  }

  void cutoff() {
    for (const float cutoff : levels<float>({0.2f, 0.05f, 0.01f, 0.004f},
                                            {0.2f, 0.1f, 0.05f, 0.02f, 0.01f, 0.004f, 0.001f})) {
      Settings settings = base_;
      settings.trace.importance_cutoff = cutoff;
      settings.trace.max_depth = 32;  // deep enough for the cut-off to end all branches
      SweepPoint& point =
          add("cut-off", frame::exact_text(cutoff), static_cast<double>(cutoff), settings);
      point.limit = same_as(settings);
      point.limit->importance_cutoff = quality_.limit_cutoff;
    }
  }

  // The exact picture with very many lights would take days with many samples. So it has the
  // point's own samples, at the same places: what remains is the error of the lights.
  void lights() {
    const auto measure = [&](const std::string& label, double value,
                             const scene::EnvLightOptions& lights) {
      Settings settings = base_;
      settings.env_lights = lights;
      SweepPoint& point = add("lights", label, value, settings);
      point.reference = same_as(settings);
      point.reference.env_lights = {scene::EnvLightOptions::Method::MedianCut, quality_.lights};
      point.limit = point.reference;
    };
    measure("sectors", kNoNumber, base_.env_lights);
    for (const int count : levels<int>({2, 4, 16}, {1, 2, 4, 8, 16, 32, 64, 128})) {
      measure("median-cut:" + std::to_string(count), count,
              {scene::EnvLightOptions::Method::MedianCut, count});
    }
  }

  void fresnel() {
    add("fresnel", "schlick", kNoNumber, base_);
    Settings settings = base_;
    settings.trace.fresnel = trace::FresnelModel::Exact;
    add("fresnel", "exact", kNoNumber, settings);
  }

  void shadow_edges() {
    add("shadow edges", "map", kNoNumber, base_);
    Settings settings = base_;
    settings.trace_shadow_edges = true;
    add("shadow edges", "traced", kNoNumber, settings);
  }

  void jpeg() {
    add("JPEG quality", "patch", kNoNumber, base_);
    for (const int quality : levels<int>({50, 75, 95}, {10, 25, 50, 75, 85, 90, 94, 95, 98, 100})) {
      add("JPEG quality", std::to_string(quality), quality, base_).jpeg_quality = quality;
    }
  }

  void render_scale() {
    for (const float scale :
         levels<float>({0.5f, 0.75f, 1.0f}, {0.25f, 0.5f, 0.66f, 0.75f, 1.0f})) {
      Settings settings = base_;
      settings.render_scale = scale;
      add("render scale", frame::exact_text(scale), static_cast<double>(scale), settings);
    }
  }

  void joint() {
    Settings settings = base_;
    add("joint", "default", kNoNumber, settings);
    settings.render_scale = 0.5f;
    settings.trace.max_depth = 4;
    settings.trace.importance_cutoff = 0.1f;
    add("joint", "fast", kNoNumber, settings);
    settings = base_;
    settings.adaptive_threshold = frame::kDefaultAdaptiveThreshold;
    settings.trace.importance_cutoff = 0.02f;
    settings.trace_shadow_edges = true;
    add("joint", "good", kNoNumber, settings);
    settings = base_;
    settings.samples_per_pixel = 16;
    settings.trace.max_depth = 32;
    settings.trace.importance_cutoff = 0.004f;
    settings.trace.fresnel = trace::FresnelModel::Exact;
    settings.trace_shadow_edges = true;
    add("joint", "best", kNoNumber, settings);
  }

  static constexpr int kDeepest = 10'000;  // no ray gets there

  bool quick_;
  bool stiff_ = false;
  std::optional<double> reflectance_;
  ReferenceQuality quality_;
  Settings base_;
  std::vector<SweepPoint> points_;
};

}  // namespace

std::string to_string(const ReferenceSpec& spec) {
  const std::string n = std::to_string(spec.samples_per_side);
  return n + "x" + n + " samples, depth " + std::to_string(spec.max_depth) + ", cut-off " +
         frame::exact_text(spec.importance_cutoff) +
         (spec.exact_fresnel ? ", exact Fresnel" : ", Schlick") + ", lights " +
         scene::to_string(spec.env_lights);
}

ReferenceQuality full_quality() {
  return {};
}

ReferenceQuality quick_quality() {
  return {.samples_per_side = 8,
          .max_depth = 64,
          .importance_cutoff = 1e-3,
          .limit_cutoff = 1e-4,
          .lights = 64};
}

ReferenceSpec best_reference(const ReferenceQuality& quality) {
  return {.samples_per_side = quality.samples_per_side,
          .max_depth = quality.max_depth,
          .importance_cutoff = quality.importance_cutoff,
          .exact_fresnel = true,
          .env_lights = {}};
}

std::vector<SweepPoint> make_sweeps(const SweepOptions& options) {
  return Sweeps(options).all();
}

std::vector<std::string> sweep_names() {
  std::vector<std::string> names;
  for (const SweepPoint& point : make_sweeps({.quick = true})) {
    if (names.empty() || names.back() != point.sweep) names.push_back(point.sweep);
  }
  return names;
}

}  // namespace amalgam::report
