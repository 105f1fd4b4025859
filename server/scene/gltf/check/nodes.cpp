#include <algorithm>
#include <cmath>
#include <set>

#include "scene/gltf/check/check_context.h"
#include "scene/gltf/check/limits.h"

// The hierarchy must be a forest: every node has one parent at most and no node is its own
// ancestor.

namespace amalgam::scene {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// Parent of each node. Fails for two parents; with one parent at most, whatever cannot be reached
// from a root is in a loop.
std::vector<std::size_t> find_parents(const GltfCheckContext& context) {
  const auto& nodes = context.all("nodes");
  std::vector<std::size_t> parents(nodes.size(), kNone);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto children = nodes[i].find("children");
    if (!children) continue;
    for (const JsonCursor& at : context.listed(*children)) {
      const std::size_t child = context.resolve(at, "nodes");
      if (parents[child] != kNone) at.fail("node " + std::to_string(child) + " has two parents");
      parents[child] = i;
    }
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::size_t steps = 0;
    for (std::size_t at = i; at != kNone; at = parents[at]) {
      if (++steps > kMaxNodeDepth)
        nodes[i].fail("is its own ancestor, or nested more than 1000 deep");
    }
  }
  return parents;
}

void check_transform(const GltfCheckContext& context, const JsonCursor& node) {
  const auto matrix = node.find("matrix");
  for (const char* name : {"translation", "rotation", "scale"}) {
    const auto part = node.find(name);
    if (part && matrix) matrix->fail("stands beside " + std::string(name));
  }
  if (matrix) {
    const auto m = matrix->numbers(16);
    constexpr double kRounding = 1e-5;
    const double error =
        std::max({std::abs(m[3]), std::abs(m[7]), std::abs(m[11]), std::abs(m[15] - 1.0)});
    if (!(error <= kRounding)) matrix->fail("its last row is not 0 0 0 1");
    if (error > 0.0) context.note(*matrix, "its last row is not quite 0 0 0 1");
  }
  if (const auto translation = node.find("translation")) translation->numbers(3);
  if (const auto scale = node.find("scale")) scale->numbers(3);
  if (const auto rotation = node.find("rotation")) {
    const auto q = rotation->numbers(4);
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    // Three decimal digits are as good as it gets by hand. A quaternion that is further off may
    // mean another matrix.
    constexpr double kHand = 0.01, kMaxError = 0.1;
    if (!(std::abs(length - 1.0) <= kMaxError)) rotation->fail("is not a unit quaternion");
    if (std::abs(length - 1.0) > kHand) context.note(*rotation, "brought to length 1");
  }
}

void check_deformation(const GltfCheckContext& context, const std::optional<JsonCursor>& mesh,
                       const std::optional<JsonCursor>& skin,
                       const std::optional<JsonCursor>& weights) {
  if (skin) context.resolve(*skin, "skins");
  if (skin && !mesh) skin->fail("needs a mesh");
  if (weights && !mesh) weights->fail("needs a mesh");
  if (!mesh || (!skin && !weights)) return;
  const JsonCursor& used = context.all("meshes")[context.resolve(*mesh, "meshes")];
  const auto first = used.get("primitives").front();
  if (!first) return;
  if (skin && !first->get("attributes").find("JOINTS_0")) skin->fail("its mesh has no JOINTS_0");
  if (weights) {
    const auto targets = first->find("targets");
    if (weights->size() != (targets ? targets->size() : 0)) {
      weights->fail("has not as many numbers as the mesh has morph targets");
    }
  }
}

void check_mesh_use(const GltfCheckContext& context, const JsonCursor& node) {
  const auto mesh = node.find("mesh"), skin = node.find("skin"), weights = node.find("weights");
  if (mesh) context.resolve(*mesh, "meshes");
  context.note_if_wrong("skins and morph targets are not used",
                        [&] { check_deformation(context, mesh, skin, weights); });
}

// Every node draws all primitives of its mesh, so that a small file can ask for any number.
void check_instances(const GltfCheckContext& context) {
  std::vector<std::size_t> primitives;
  for (const JsonCursor& mesh : context.all("meshes")) {
    primitives.push_back(mesh.get("primitives").size());
  }
  std::size_t instances = 0;
  for (const JsonCursor& node : context.all("nodes")) {
    const auto mesh = node.find("mesh");
    if (mesh) instances += primitives[context.resolve(*mesh, "meshes")];
    if (instances > kMaxInstances) node.fail("the nodes draw more than a million primitives");
  }
}

void check_scenes(const GltfCheckContext& context, const std::vector<std::size_t>& parents) {
  for (const JsonCursor& scene : context.all("scenes")) {
    const auto nodes = scene.find("nodes");
    if (!nodes) continue;
    std::set<std::size_t> seen;
    for (const JsonCursor& at : context.listed(*nodes)) {
      const std::size_t node = context.resolve(at, "nodes");
      if (parents[node] != kNone) at.fail("node " + std::to_string(node) + " is not a root node");
      if (!seen.insert(node).second) at.fail("node " + std::to_string(node) + " occurs twice");
    }
  }
  if (const auto scene = context.root.find("scene")) context.resolve(*scene, "scenes");
}

std::vector<std::size_t> ancestors(const std::vector<std::size_t>& parents, std::size_t node) {
  std::vector<std::size_t> line;
  for (std::size_t at = node; at != kNone; at = parents[at]) line.push_back(at);
  return line;
}

}  // namespace

void check_nodes(const GltfCheckContext& context) {
  const auto parents = find_parents(context);
  for (const JsonCursor& node : context.all("nodes")) {
    if (const auto name = node.find("name")) name->string();
    if (const auto camera = node.find("camera")) {
      context.note_if_wrong("cameras are not used", [&] { context.resolve(*camera, "cameras"); });
    }
    check_transform(context, node);
    check_mesh_use(context, node);
  }
  check_instances(context);
  check_scenes(context, parents);
}

void check_skins(const GltfCheckContext& context) {
  const auto parents = find_parents(context);
  for (const JsonCursor& skin : context.all("skins")) {
    std::set<std::size_t> joints;
    for (const JsonCursor& at : context.listed(skin.get("joints"))) {
      const std::size_t joint = context.resolve(at, "nodes");
      if (!joints.insert(joint).second) at.fail("occurs twice");
    }
    if (joints.empty()) continue;
    const std::size_t root = ancestors(parents, *joints.begin()).back();
    const auto skeleton = skin.find("skeleton");
    const std::size_t above = skeleton ? context.resolve(*skeleton, "nodes") : root;
    for (const std::size_t joint : joints) {
      const auto line = ancestors(parents, joint);
      if (line.back() != root) skin.fail("its joints have no common root");
      if (std::find(line.begin(), line.end(), above) == line.end()) {
        skeleton->fail("is not above all joints");
      }
    }
    if (const auto matrices = skin.find("inverseBindMatrices")) {
      const AccessorFacts& accessor = context.accessors[context.resolve(*matrices, "accessors")];
      if (accessor.type != "MAT4" || accessor.component != kFloat) {
        matrices->fail("are not 4x4 float matrices");
      }
      if (accessor.count < static_cast<long long>(joints.size())) {
        matrices->fail("are fewer than the joints");
      }
      if (accessor.view && context.views[*accessor.view].stride) {
        matrices->fail("cannot have a byteStride");
      }
    }
  }
}

}  // namespace amalgam::scene
