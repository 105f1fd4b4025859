// The transparent media that a ray is in, outermost first: glass, and perhaps a bubble in it.
#pragma once

#include <array>
#include <cstddef>

#include "support/reference/world.h"

namespace amalgam::reference {

class MediaStack {
 public:
  static constexpr std::size_t kCapacity = 4;  // one more, and the outermost is forgotten

  bool empty() const { return size_ == 0; }

  // Null: air.
  const Object* innermost() const { return size_ == 0 ? nullptr : media_[size_ - 1]; }

  // Null: air, without virtual objects.
  const Object* innermost_real() const {
    for (std::size_t i = size_; i-- > 0;) {
      if (media_[i]->role == scene::Role::Real) return media_[i];
    }
    return nullptr;
  }

  MediaStack entered(const Object& medium) const {
    MediaStack result = *this;
    if (result.size_ == kCapacity) result.remove(0);
    result.media_[result.size_++] = &medium;
    return result;
  }

  // Without the last entry of that material; unchanged if there is none.
  MediaStack left(const Object& medium) const {
    MediaStack result = *this;
    for (std::size_t i = size_; i-- > 0;) {
      if (media_[i]->medium == medium.medium) {
        result.remove(i);
        break;
      }
    }
    return result;
  }

 private:
  void remove(std::size_t index) {
    for (std::size_t i = index; i + 1 < size_; ++i) media_[i] = media_[i + 1];
    --size_;
  }

  std::array<const Object*, kCapacity> media_{};
  std::size_t size_ = 0;
};

inline double refractive_index(const Object* medium) {
  return medium == nullptr ? 1.0 : static_cast<double>(medium->material.ior);
}

// In a medium the same light has n^2 times the radiance that it has in air.
inline double squared_index(const MediaStack& media) {
  const double n = refractive_index(media.innermost());
  return n * n;
}

}  // namespace amalgam::reference
