// A bounding volume hierarchy split at the median: which boxes may a ray meet?
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "support/reference/primitives.h"

namespace amalgam::reference {

class BoundingTree {
 public:
  BoundingTree() = default;
  explicit BoundingTree(std::span<const Box> boxes);

  // Calls visit(index) for every box that the ray may meet between ray.t_min and ray.t_max. The
  // visitor may shorten ray.t_max while it runs, and ends the search by returning false.
  template <typename Visit>
  void for_each_candidate(const Ray& ray, const Visit& visit) const {
    if (!nodes_.empty()) descend(0, ray, 1.0 / ray.direction, visit);
  }

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0, count = 0;  // items of a leaf; an inner node has none
    std::uint32_t left = 0, right = 0;   // children of an inner node
  };

  std::uint32_t build(std::span<const Box> boxes, std::uint32_t first, std::uint32_t count);
  static bool may_meet(const Box& box, const Ray& ray, const Vec3& inverse_direction);

  template <typename Visit>
  bool descend(std::uint32_t index, const Ray& ray, const Vec3& inverse_direction,
               const Visit& visit) const {
    const Node& node = nodes_[index];
    if (!may_meet(node.box, ray, inverse_direction)) return true;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (!visit(items_[i])) return false;
    }
    if (node.count > 0) return true;
    return descend(node.left, ray, inverse_direction, visit) &&
           descend(node.right, ray, inverse_direction, visit);
  }

  std::vector<Node> nodes_;  // the first is the root
  std::vector<std::uint32_t> items_;
};

}  // namespace amalgam::reference
