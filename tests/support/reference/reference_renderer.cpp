#include "support/reference/reference_renderer.h"

#include <array>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "support/reference/lens.h"
#include "support/reference/media_around.h"
#include "support/reference/relative_error.h"

namespace amalgam::reference {
namespace {

// Radians, near enough: four roundings to float.
constexpr double kNudge = 0x1p-22;
// 32 units in the last place, by which the renderer lifts rays (trace/ray_offset.h says so).
constexpr double kLift = 32 * 0x1p-23;
const std::array<Vec2, 4> kNudges = {
    {{-kNudge, -kNudge}, {kNudge, -kNudge}, {-kNudge, kNudge}, {kNudge, kNudge}}};

void note_grazing(std::uint8_t& pixel, Grazing grazing) {
  pixel = std::max(pixel, static_cast<std::uint8_t>(grazing));
}

double change(const Sample& to, const Sample& from) {
  return std::max({relative_error(to.mixed, from.mixed), relative_error(to.real, from.real),
                   relative_error(to.environment_reflection, from.environment_reflection)});
}

class Rendering {
 public:
  Rendering(const World& world, const scene::Environment* environment,
            const ReferenceRequest& request)
      : request_(request),
        ideal_(common::ideal_camera_covering(request.camera)),
        view_{request.camera_image, request.camera, request.anchored.camera_from_world,
              request.response},
        inputs_{world, request.lights, environment, &view_, request.settings},
        world_from_camera_(glm::inverse(request.anchored.camera_from_world)) {
    inputs_.start_media = media_around(world, Vec3(world_from_camera_[3]));
    const int w = ideal_.width, h = ideal_.height;
    images_.mixed = images_.real = images_.environment_reflection =
        common::Image<Color>(w, h, Color(0.0));
    images_.virtual_mask = images_.specular_mask = images_.grazing = images_.rim =
        common::Image<std::uint8_t>(w, h, 0);
    images_.layers = Layers::zero(w, h);
  }

  ReferenceImages render() {
    for_each_row([this](int y) {
      for (int x = 0; x < ideal_.width; ++x) render_pixel(x, y);
    });
    const bool is_ideal = ideal_ == request_.camera;
    images_.composite =
        composite(is_ideal ? images_.layers : warp(images_.layers, request_.camera, ideal_),
                  *request_.camera_image, request_.response);
    return std::move(images_);
  }

 private:
  // Rows are shared out among all cores; each writes only its own pixels.
  template <typename Work>
  void for_each_row(const Work& work) {
    std::atomic<int> next_row = 0;
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) {
      threads.emplace_back([&] {
        for (int y = next_row++; y < ideal_.height; y = next_row++) work(y);
      });
    }
  }

  void render_pixel(int x, int y) {
    const int n = request_.samples_per_side;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const Vec2 position(x - 0.5 + (i + 0.5) / n, y - 0.5 + (j + 0.5) / n);
        Decisions decisions;
        const Sample sample = trace(position, decisions, request_.find_grazing ? kLift : 0.0);
        add_sample(images_.layers, x, y, sample, request_.response, request_.settings.ratio,
                   1.0 / (n * n));
        if (i == 0 && j == 0) keep(x, y, sample);
        if (!request_.find_grazing) continue;
        note_grazing(images_.grazing.at(x, y), grazing(position, sample, decisions));
        if (is_at_rim(position)) images_.rim.at(x, y) = 1;
      }
    }
  }

  Sample trace(const Vec2& position, Decisions& decisions, double lift) const {
    Whitted::Inputs inputs = inputs_;
    inputs.settings.lift = lift;
    return Whitted(inputs).trace(primary_ray(position), decisions);
  }

  Ray primary_ray(const Vec2& position) const {
    const Vec3 direction = glm::dmat3(world_from_camera_) * pinhole_direction(ideal_, position);
    Ray primary{Vec3(world_from_camera_[3]), glm::normalize(direction)};
    // The angle between neighbouring samples at the image's centre, all over the image.
    primary.spread = 1.0 / (ideal_.fy * request_.samples_per_side);
    return primary;
  }

  bool is_at_rim(const Vec2& position) const {
    const auto object = [this](const Vec2& at) {
      const auto hit = inputs_.world.closest(primary_ray(at));
      return hit ? hit->object + 1 : 0;
    };
    const double step = kRasterGrid / request_.samples_per_side;
    const std::array<Vec2, 8> around = {
        {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
    const auto here = object(position);
    return std::any_of(around.begin(), around.end(), [&](const Vec2& direction) {
      return object(position + step * direction) != here;
    });
  }

  Grazing grazing(const Vec2& position, const Sample& sample, const Decisions& decisions) const {
    if (decisions.is_unsure()) return Grazing::Edge;
    auto result = Grazing::No;
    for (const Vec2& nudge : kNudges) {
      Decisions nudged_decisions;
      const Sample nudged =
          trace(position + nudge * Vec2(ideal_.fx, ideal_.fy), nudged_decisions, 0.0);
      if (nudged_decisions.signature() != decisions.signature()) return Grazing::Edge;
      if (change(nudged, sample) > kSteep) result = Grazing::Steep;
    }
    return result;
  }

  void keep(int x, int y, const Sample& sample) {
    images_.mixed.at(x, y) = sample.mixed;
    images_.real.at(x, y) = sample.real;
    images_.environment_reflection.at(x, y) = sample.environment_reflection;
    images_.virtual_mask.at(x, y) = sample.met_virtual ? 1 : 0;
    images_.specular_mask.at(x, y) = sample.specular_first ? 1 : 0;
  }

  const ReferenceRequest& request_;
  common::CameraModel ideal_;
  CameraView view_;
  Whitted::Inputs inputs_;
  glm::dmat4 world_from_camera_;
  ReferenceImages images_;
};

}  // namespace

ReferenceImages render_reference(const scene::Scene& scene, const ReferenceRequest& request) {
  const World world(make_geometry(scene, request.anchored), scene.textures);
  return render_reference(world, scene.environment ? &*scene.environment : nullptr, request);
}

ReferenceImages render_reference(const World& world, const scene::Environment* environment,
                                 const ReferenceRequest& request) {
  if (request.camera_image == nullptr ||
      request.camera_image->size() != glm::ivec2(request.camera.width, request.camera.height)) {
    throw std::invalid_argument("the reference needs a camera image of the camera's size");
  }
  return Rendering(world, environment, request).render();
}

}  // namespace amalgam::reference
