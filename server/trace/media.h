// The dielectrics that a ray is inside, innermost last. With them an air bubble in glass, or a
// liquid in a cup, refracts by the indices of the two media that meet at the surface.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "scene/scene.h"

namespace amalgam::trace {

class Media {
 public:
  // Beyond this depth the outermost medium is forgotten.
  static constexpr std::size_t kMaxNested = 4;

  std::optional<std::uint32_t> innermost() const {
    return count_ == 0 ? std::nullopt : std::optional(materials_[count_ - 1]);
  }

  // The innermost one without virtual solids: where the same point lies in reality.
  std::optional<std::uint32_t> innermost_real() const {
    for (std::size_t i = count_; i-- > 0;) {
      if (roles_[i] == scene::Role::Real) return materials_[i];
    }
    return std::nullopt;
  }

  Media entered(std::uint32_t material, scene::Role role) const {
    Media next = *this;
    if (next.count_ == kMaxNested) next.remove(0);
    next.roles_[next.count_] = role;
    next.materials_[next.count_++] = material;
    return next;
  }

  // Leaves the innermost medium of that material. Leaving a medium that was never entered (an open
  // mesh) changes nothing.
  Media left(std::uint32_t material) const {
    Media next = *this;
    for (std::size_t i = next.count_; i-- > 0;) {
      if (next.materials_[i] == material) {
        next.remove(i);
        break;
      }
    }
    return next;
  }

 private:
  void remove(std::size_t index) {
    for (std::size_t i = index; i + 1 < count_; ++i) {
      materials_[i] = materials_[i + 1];
      roles_[i] = roles_[i + 1];
    }
    --count_;
  }

  std::array<std::uint32_t, kMaxNested> materials_{};
  std::array<scene::Role, kMaxNested> roles_{};
  std::uint8_t count_ = 0;
};

// Of the innermost medium; 1 in air.
inline double refractive_index(const Media& media, std::span<const scene::Material> materials) {
  const auto medium = media.innermost();
  return medium ? double{materials[*medium].ior} : 1.0;
}

}  // namespace amalgam::trace
