#include "bench/povray/pov_material.h"

#include <algorithm>
#include <sstream>

#include "bench/povray/pov_text.h"

namespace amalgam::bench {
namespace {

void write_diffuse(std::ostream& out, const scene::Material& material) {
  const scene::PhongTerms terms = scene::phong_terms(material, glm::vec3(material.base_color));
  // Ours is specular (n + 2) / (2 pi) lobe; lights are divided by pi already.
  const double phong =
      static_cast<double>(std::max({terms.specular.x, terms.specular.y, terms.specular.z}) *
                          (terms.exponent + 2.0f)) /
      2.0;
  out << "texture { pigment { color rgb " << pov_vector(terms.albedo)
      << " } finish { ambient 0 diffuse 1 phong " << phong << " phong_size "
      << std::max(terms.exponent, 1.0f) << " } }\n";
}

void write_mirror(std::ostream& out, const scene::Material& material) {
  out << "texture { pigment { color rgb 0 } finish { ambient 0 diffuse 0 reflection { color rgb "
      << pov_vector(glm::vec3(material.base_color)) << " } } }\n";
}

void write_glass(std::ostream& out, const scene::Material& material) {
  out << "texture { pigment { color rgbt <1, 1, 1, 1> } finish { ambient 0 diffuse 0 reflection { "
         "0, 1 fresnel on } conserve_energy } }\n";
  out << "interior { ior " << material.ior;
  const double most = static_cast<double>(
      std::max({material.absorption.x, material.absorption.y, material.absorption.z}));
  // From a fade_power of 1000 on the law is exponential: exp(-(1 - fade_color) d / fade_distance).
  if (most > 0.0) {
    out << " fade_distance " << 1.0 / most << " fade_power 1001 fade_color rgb "
        << pov_vector(1.0 - glm::dvec3(material.absorption) / most);
  }
  out << " }\n";
}

}  // namespace

std::string pov_material(const scene::Material& material) {
  std::ostringstream out;
  switch (material.kind) {
    case scene::MaterialKind::Diffuse:
      write_diffuse(out, material);
      break;
    case scene::MaterialKind::Mirror:
      write_mirror(out, material);
      break;
    case scene::MaterialKind::Dielectric:
      write_glass(out, material);
      break;
  }
  return out.str();
}

}  // namespace amalgam::bench
