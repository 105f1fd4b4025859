#include "support/reference/bounding_tree.h"

#include <numeric>

namespace amalgam::reference {
namespace {

constexpr std::uint32_t kMostInLeaf = 2;

glm::length_t longest_axis(const Vec3& extent) {
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

}  // namespace

BoundingTree::BoundingTree(std::span<const Box> boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0u);
  if (!boxes.empty()) build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
}

std::uint32_t BoundingTree::build(std::span<const Box> boxes, std::uint32_t first,
                                  std::uint32_t count) {
  Node node;
  Box centres;
  for (std::uint32_t i = first; i < first + count; ++i) {
    node.box.include(boxes[items_[i]]);
    centres.include(0.5 * (boxes[items_[i]].low + boxes[items_[i]].high));
  }
  // Slab tests round; a box that is a little too large only costs a test.
  const Vec3 margin = 1e-12 * (1.0 + glm::abs(node.box.low) + glm::abs(node.box.high));
  node.box.low -= margin;
  node.box.high += margin;

  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node);
  if (count <= kMostInLeaf) {
    nodes_[index].first = first;
    nodes_[index].count = count;
    return index;
  }
  const glm::length_t axis = longest_axis(centres.high - centres.low);
  const auto begin = items_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    return boxes[a].low[axis] + boxes[a].high[axis] < boxes[b].low[axis] + boxes[b].high[axis];
  });
  const std::uint32_t left = build(boxes, first, count / 2);
  const std::uint32_t right = build(boxes, first + count / 2, count - count / 2);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return index;
}

bool BoundingTree::may_meet(const Box& box, const Ray& ray, const Vec3& inverse_direction) {
  double near = ray.t_min, far = ray.t_max;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0.0) {
      if (ray.origin[axis] < box.low[axis] || ray.origin[axis] > box.high[axis]) return false;
      continue;
    }
    const double a = (box.low[axis] - ray.origin[axis]) * inverse_direction[axis];
    const double b = (box.high[axis] - ray.origin[axis]) * inverse_direction[axis];
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  return near <= far;
}

}  // namespace amalgam::reference
