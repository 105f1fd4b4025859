#include <algorithm>
#include <map>
#include <set>

#include "scene/gltf/check/check_context.h"

namespace amalgam::scene {
namespace {

constexpr int kVertices = 34962, kIndices = 34963;

struct Semantic {
  std::string base;  // POSITION, TEXCOORD, ...
  int set = 0;       // n of TEXCOORD_n
};

Semantic parse_semantic(const JsonCursor& at, const std::string& name) {
  for (const char* plain : {"POSITION", "NORMAL", "TANGENT"}) {
    if (name == plain) return {name, 0};
  }
  const std::size_t dash = name.find('_');
  if (dash != std::string::npos && dash > 0) {
    const std::string base = name.substr(0, dash), set = name.substr(dash + 1);
    const bool digits =
        !set.empty() && set.size() <= 3 && (set == "0" || set[0] != '0') &&
        std::all_of(set.begin(), set.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (digits &&
        (base == "TEXCOORD" || base == "COLOR" || base == "JOINTS" || base == "WEIGHTS")) {
      return {base, std::stoi(set)};
    }
  }
  at.fail("is not an attribute (names of one's own begin with an underscore)");
}

bool is_format_allowed(const std::string& base, const AccessorFacts& accessor, bool morph) {
  const bool is_float = accessor.component == kFloat;
  const bool unorm = accessor.normalized &&
                     (accessor.component == kUnsignedByte || accessor.component == kUnsignedShort);
  const bool snorm = accessor.normalized;
  const std::string& type = accessor.type;
  if (base == "POSITION" || base == "NORMAL") return type == "VEC3" && is_float;
  if (base == "TANGENT") return type == (morph ? "VEC3" : "VEC4") && is_float;
  if (base == "TEXCOORD") return type == "VEC2" && (is_float || unorm || (morph && snorm));
  if (base == "COLOR") {
    return (type == "VEC3" || type == "VEC4") && (is_float || unorm || (morph && snorm));
  }
  if (base == "WEIGHTS") return type == "VEC4" && (is_float || unorm);
  return type == "VEC4" && !accessor.normalized &&
         (accessor.component == kUnsignedByte || accessor.component == kUnsignedShort);  // JOINTS
}

class MeshChecker {
 public:
  explicit MeshChecker(const GltfCheckContext& context) : context_(context) {}

  void check_primitive(const JsonCursor& primitive) {
    const JsonCursor attributes = primitive.get("attributes");
    const long long vertices = check_attributes(attributes);
    if (const auto indices = primitive.find("indices")) check_indices(*indices);
    if (const auto material = primitive.find("material")) context_.resolve(*material, "materials");
    if (const auto mode = primitive.find("mode")) mode->integer(0, 6);
    if (const auto targets = primitive.find("targets")) {
      for (const JsonCursor& target : targets->filled_items()) {
        check_morph_target(target, attributes, vertices);
      }
    }
  }

 private:
  // Returns the number of vertices, 0 without positions.
  long long check_attributes(const JsonCursor& attributes) {
    const auto members = attributes.members();
    if (members.empty()) attributes.fail("is empty; leave the primitive out instead");
    std::optional<long long> vertices;
    std::map<std::string, std::set<int>> sets;
    for (const auto& [name, at] : members) {
      const AccessorFacts& accessor = vertex_accessor(at);
      if (vertices.value_or(accessor.count) != accessor.count) {
        at.fail("has another count than the primitive's other attributes");
      }
      vertices = accessor.count;
      if (accessor.component == kUnsignedInt) at.fail("attributes cannot be unsigned int");
      if (name.starts_with('_')) continue;
      const Semantic semantic = parse_semantic(at, name);
      if (!is_format_allowed(semantic.base, accessor, false)) {
        at.fail("its accessor has a format that this attribute cannot have");
      }
      if (name == "POSITION" && !accessor.has_bounds)
        context_.note(at, "its accessor has no min and max");
      sets[semantic.base].insert(semantic.set);
    }
    for (const auto& [base, numbers] : sets) {
      if (*numbers.rbegin() != static_cast<int>(numbers.size()) - 1) {
        attributes.fail(base + "_n are not numbered 0, 1, 2, ...");
      }
    }
    if (sets["JOINTS"].size() != sets["WEIGHTS"].size()) {
      attributes.fail("has not as many WEIGHTS_n as JOINTS_n");
    }
    if (!sets.contains("POSITION")) context_.note(attributes, "has no POSITION; not drawn");
    return vertices.value_or(0);
  }

  const AccessorFacts& vertex_accessor(const JsonCursor& at) {
    const AccessorFacts& accessor = context_.accessors[context_.resolve(at, "accessors")];
    if (accessor.view) {
      use_view(at, *accessor.view, kVertices);
      const ViewFacts& view = context_.views[*accessor.view];
      const long long element = static_cast<long long>(component_bytes(accessor.component)) *
                                component_count(accessor.type);
      if (accessor.offset % 4 != 0 || view.stride.value_or(element) % 4 != 0) {
        at.fail("vertex data are not aligned to 4 bytes");
      }
    }
    return accessor;
  }

  void check_indices(const JsonCursor& at) {
    const AccessorFacts& accessor = context_.accessors[context_.resolve(at, "accessors")];
    const bool is_unsigned = accessor.component == kUnsignedByte ||
                             accessor.component == kUnsignedShort ||
                             accessor.component == kUnsignedInt;
    if (accessor.type != "SCALAR" || !is_unsigned || accessor.normalized) {
      at.fail("indices are not unsigned integers");
    }
    if (!accessor.view) return;
    if (context_.views[*accessor.view].stride) at.fail("indices cannot have a byteStride");
    use_view(at, *accessor.view, kIndices);
  }

  void check_morph_target(const JsonCursor& target, const JsonCursor& attributes,
                          long long vertices) {
    for (const auto& [name, at] : target.members()) {
      const AccessorFacts& accessor = vertex_accessor(at);
      if (accessor.count != vertices) at.fail("has another count than the base attributes");
      if (name.starts_with('_')) continue;
      if (!attributes.find(name)) at.fail("has no base attribute");
      if (!is_format_allowed(parse_semantic(at, name).base, accessor, true)) {
        at.fail("its accessor has a format that this attribute cannot have");
      }
      if (name == "POSITION" && !accessor.has_bounds)
        context_.note(at, "its accessor has no min and max");
    }
  }

  // A view may hold vertices or indices, never both.
  void use_view(const JsonCursor& at, std::size_t view, int target) {
    const int said = context_.views[view].target.value_or(target);
    const int used = use_.emplace(view, target).first->second;
    if (said != target || used != target)
      at.fail("its bufferView is for vertices and indices both");
  }

  const GltfCheckContext& context_;
  std::map<std::size_t, int> use_;
};

std::size_t target_count(const JsonCursor& primitive) {
  const auto targets = primitive.find("targets");
  return targets ? targets->items().size() : 0;
}

}  // namespace

void check_meshes(const GltfCheckContext& context) {
  MeshChecker checker(context);
  for (const JsonCursor& mesh : context.all("meshes")) {
    const auto primitives = mesh.get("primitives").filled_items();
    for (const JsonCursor& primitive : primitives) {
      checker.check_primitive(primitive);
      if (target_count(primitive) != target_count(primitives.front())) {
        primitive.fail("has not as many morph targets as the mesh's first primitive");
      }
    }
    if (const auto weights = mesh.find("weights")) {
      if (weights->filled_items().size() != target_count(primitives.front())) {
        weights->fail("has not as many numbers as there are morph targets");
      }
    }
  }
}

}  // namespace amalgam::scene
