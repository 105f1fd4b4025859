// One ray of the differential ray tracer, followed recursively (sections 4.2 to 4.4): a single
// tree of rays carries the image with and the image without virtual objects.
#pragma once

#include <span>

#include "scene/light/environment.h"
#include "scene/light/light.h"
#include "support/reference/camera_lookup.h"
#include "support/reference/decisions.h"
#include "support/reference/fresnel.h"
#include "support/reference/media_stack.h"
#include "support/reference/phong.h"
#include "support/reference/world.h"

namespace amalgam::reference {

struct TraceSettings {
  int max_depth = 10;                // specular surfaces that a ray may meet
  double importance_cutoff = 0.004;  // a branch of less weight takes the environment
  Fresnel fresnel = Fresnel::Schlick;
  // Set: it is noted as unsure (decisions.h) where a secondary ray would meet something else if it
  // began this much above the surface, in relation to Object::coordinate_size. Renderers
  // in float lift their rays so that they do not meet the same surface again.
  double lift = 0.0;
  bool ratio = true;  // look-ups change by ratio (real_change.h)
};

struct Sample {
  Color mixed{0.0};                   // I_m, scene-linear
  Color real{0.0};                    // I_r, scene-linear
  Color environment_reflection{0.0};  // I_e, display-linear
  bool met_virtual = false;           // M_v
  bool specular_first = false;        // M_r: the first surface is a mirror or glass
  bool real_diffuse_first = false;
};

class Whitted {
 public:
  struct Inputs {
    const World& world;
    std::span<const scene::Light> lights;
    const scene::Environment* environment = nullptr;  // null: black
    const CameraView* camera_view = nullptr;          // null: no look-ups
    TraceSettings settings;
    MediaStack start_media{};  // that primary rays begin in
  };

  explicit Whitted(const Inputs& inputs) : in_(inputs) {}

  Sample trace(const Ray& primary, Decisions& decisions) const;

 private:
  // A ray, what its radiance counts for in the sample, and what it is in.
  struct Branch {
    Ray ray;
    Color weight{1.0};
    int depth = 0;
    MediaStack media{};
    Vec3 lift{0.0};  // see TraceSettings; from the ray's origin
  };
  // A hit seen from the side that the ray came from.
  struct Surface {
    const Hit& hit;
    const Object& object;
    Vec3 geometric_normal;  // facing
    Vec3 shading_normal;    // on the same side of the mesh; bent by a normal texture
    Vec3 to_viewer;
    SurfaceMaterial material;
    Color base_color() const { return Color(material.base_color); }
  };
  struct Collector {
    Sample& sample;
    Decisions& decisions;
  };
  // The same point lit with the mixed and with the real attenuation.
  struct Shaded {
    Color mixed, real;
  };

  void follow(const Branch& branch, Collector& to) const;
  void note_lift(const Branch& branch, const std::optional<Hit>& hit, Collector& to) const;
  void spawn(const Branch& child, Collector& to) const;
  void add_environment(const Branch& branch, Collector& to) const;
  void add_diffuse(const Branch& branch, const Surface& surface, Collector& to) const;
  // The surface's light from all lights. The branch's weight says whether a light matters at all.
  Shaded illuminate(const Phong& phong, const Branch& branch, const Surface& surface,
                    Collector& to) const;
  void meet_mirror(const Branch& branch, const Surface& surface, Collector& to) const;
  // These are in whitted_glass.cpp. share: of the light that phong sends back.
  void meet_thin_glass(const Branch& branch, const Surface& surface, Collector& to) const;
  void meet_glass(const Branch& branch, const Surface& surface, Collector& to) const;
  void add_scattered(const Branch& branch, const Surface& surface, double share, const Phong& phong,
                     Collector& to) const;

  // The shading normal that reflections and refractions are taken at (bent_normal.h).
  static Vec3 mirror_normal(const Surface& surface);
  Branch child_of(const Branch& parent, const Surface& surface, const Vec3& direction,
                  const Color& share) const;

  Inputs in_;
};

}  // namespace amalgam::reference
