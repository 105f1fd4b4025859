#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "scene/gltf/check/check_context.h"
#include "scene/gltf/check/limits.h"

namespace amalgam::scene {
namespace {

struct Semantic {
  std::string base;  // POSITION, TEXCOORD, ...
  int set = 0;       // n of TEXCOORD_n
};

// Nothing for a name that is not glTF's.
std::optional<Semantic> parse_semantic(const std::string& name) {
  for (const char* plain : {"POSITION", "NORMAL", "TANGENT"}) {
    if (name == plain) return Semantic{name, 0};
  }
  const std::size_t dash = name.find('_');
  if (dash != std::string::npos && dash > 0) {
    const std::string base = name.substr(0, dash), set = name.substr(dash + 1);
    const bool digits =
        !set.empty() && set.size() <= 3 && (set == "0" || set[0] != '0') &&
        std::all_of(set.begin(), set.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (digits &&
        (base == "TEXCOORD" || base == "COLOR" || base == "JOINTS" || base == "WEIGHTS")) {
      return Semantic{base, std::stoi(set)};
    }
  }
  return std::nullopt;
}

// What KHR_mesh_quantization adds: 8 and 16 bits.
bool is_quantized_format(const std::string& base, const AccessorFacts& accessor) {
  if (accessor.component == kFloat || accessor.component == kUnsignedInt) return false;
  const bool is_signed = accessor.component == kByte || accessor.component == kShort;
  if (base == "POSITION") return accessor.type == "VEC3";
  if (base == "TEXCOORD") return accessor.type == "VEC2";
  if (base == "NORMAL") return accessor.type == "VEC3" && is_signed && accessor.normalized;
  return base == "TANGENT" && accessor.type == "VEC4" && is_signed && accessor.normalized;
}

bool is_format_allowed(const std::string& base, const AccessorFacts& accessor) {
  const bool is_float = accessor.component == kFloat;
  const bool unorm = accessor.normalized &&
                     (accessor.component == kUnsignedByte || accessor.component == kUnsignedShort);
  const std::string& type = accessor.type;
  if (base == "POSITION" || base == "NORMAL") return type == "VEC3" && is_float;
  if (base == "TANGENT") return type == "VEC4" && is_float;
  if (base == "TEXCOORD") return type == "VEC2" && (is_float || unorm);
  if (base == "COLOR") {
    return (type == "VEC3" || type == "VEC4") && (is_float || unorm);
  }
  return true;  // JOINTS and WEIGHTS are not read
}

// What is read of a vertex.
bool is_read(const std::string& name) {
  const auto semantic = parse_semantic(name);
  return semantic && semantic->base != "JOINTS" && semantic->base != "WEIGHTS" &&
         (semantic->base != "COLOR" || semantic->set == 0);
}

bool is_draco(const JsonCursor& primitive) {
  const auto extensions = primitive.find("extensions");
  return extensions && extensions->find("KHR_draco_mesh_compression");
}

class MeshChecker {
 public:
  explicit MeshChecker(const GltfCheckContext& context) : context_(context) {}

  void check_primitive(const JsonCursor& primitive) {
    const JsonCursor attributes = primitive.get("attributes");
    is_compressed_ = is_draco(primitive);
    compressed_.clear();
    if (is_compressed_) check_draco(primitive);
    const long long vertices = check_attributes(attributes);
    if (const auto indices = primitive.find("indices")) check_indices(*indices);
    if (const auto material = primitive.find("material")) context_.resolve(*material, "materials");
    if (const auto mode = primitive.find("mode")) mode->integer(0, 6);
    if (const auto targets = primitive.find("targets")) {
      context_.note(*targets, "morph targets ignored");
      context_.note_if_wrong("morph targets are not used", [&] {
        for (const JsonCursor& target : context_.listed(*targets)) {
          for (const auto& [name, at] : target.members()) {
            if (vertex_accessor(at, false).count != vertices)
              at.fail("has another count than the base attributes");
          }
        }
      });
    }
  }

 private:
  // Returns the number of vertices, 0 without positions.
  long long check_attributes(const JsonCursor& attributes) {
    const auto members = attributes.members();
    std::optional<long long> vertices;
    std::map<std::string, std::set<int>> sets;
    for (const auto& [name, at] : members) {
      if (!is_read(name)) {
        check_unread(name, at);
        continue;
      }
      const AccessorFacts& accessor = vertex_accessor(at, compressed_.contains(name));
      if (vertices.value_or(accessor.count) != accessor.count) {
        at.fail("has another count than the primitive's other attributes");
      }
      vertices = accessor.count;
      const Semantic semantic = *parse_semantic(name);
      check_format(at, semantic.base, accessor);
      if (name == "POSITION" && !accessor.has_bounds)
        context_.note(at, "its accessor has no min and max");
      sets[semantic.base].insert(semantic.set);
    }
    for (const auto& [base, numbers] : sets) {
      if (*numbers.rbegin() != static_cast<int>(numbers.size()) - 1) {
        context_.note(attributes, base + "_n are not numbered 0, 1, 2, ...");
      }
    }
    if (!sets.contains("POSITION")) context_.note(attributes, "has no POSITION; not drawn");
    return vertices.value_or(0);
  }

  void check_format(const JsonCursor& at, const std::string& base, const AccessorFacts& accessor) {
    if (is_format_allowed(base, accessor)) return;
    if (!is_quantized_format(base, accessor))
      at.fail("its accessor has a format that this attribute cannot have");
    if (!context_.uses("KHR_mesh_quantization"))
      context_.note(at, "has a format of KHR_mesh_quantization, which is not declared");
  }

  void check_unread(const std::string& name, const JsonCursor& at) {
    if (!name.starts_with('_') && !parse_semantic(name)) {
      context_.note(at, "is not an attribute (names of one's own begin with an underscore)");
    }
    context_.note_if_wrong("not used", [&] { vertex_accessor(at, compressed_.contains(name)); });
  }

  void check_draco(const JsonCursor& primitive) {
    const JsonCursor draco = primitive.get("extensions").get("KHR_draco_mesh_compression");
    const JsonCursor view_at = draco.get("bufferView");
    draco_bytes_ += context_.views[context_.resolve(view_at, "bufferViews")].length;
    if (draco_bytes_ > kMaxBufferBytes) {
      view_at.fail("the compressed blocks of all primitives are larger than 512 MiB");
    }
    for (const auto& [name, id] : draco.get("attributes").members()) {
      id.integer(0, 65535);
      compressed_.insert(name);
    }
  }

  // is_compressed: its data are in the primitive's Draco block.
  const AccessorFacts& checked_accessor(const JsonCursor& at, bool is_compressed) {
    const AccessorFacts& accessor = context_.accessors[context_.resolve(at, "accessors")];
    if (!accessor.view && !is_compressed && accessor.count > kMaxZeros) {
      at.fail("has more than a million elements and no data");
    }
    return accessor;
  }

  const AccessorFacts& vertex_accessor(const JsonCursor& at, bool is_compressed) {
    const AccessorFacts& accessor = checked_accessor(at, is_compressed);
    if (accessor.view) {
      const ViewFacts& view = context_.views[*accessor.view];
      const long long element = static_cast<long long>(component_bytes(accessor.component)) *
                                component_count(accessor.type);
      if (accessor.offset % 4 != 0 || view.stride.value_or(element) % 4 != 0) {
        context_.note(at, "vertex data are not aligned to 4 bytes");
      }
    }
    return accessor;
  }

  void check_indices(const JsonCursor& at) {
    const AccessorFacts& accessor = checked_accessor(at, is_compressed_);
    const bool is_unsigned = accessor.component == kUnsignedByte ||
                             accessor.component == kUnsignedShort ||
                             accessor.component == kUnsignedInt;
    if (accessor.type != "SCALAR" || !is_unsigned || accessor.normalized) {
      at.fail("indices are not unsigned integers");
    }
    if (accessor.view && context_.views[*accessor.view].stride)
      context_.note(at, "indices cannot have a byteStride");
  }

  const GltfCheckContext& context_;
  bool is_compressed_ = false;        // the primitive has a Draco block
  std::set<std::string> compressed_;  // its attributes
  long long draco_bytes_ = 0;         // of all primitives so far
};

std::size_t target_count(const JsonCursor& primitive) {
  const auto targets = primitive.find("targets");
  return targets ? targets->size() : 0;
}

void check_targets(const JsonCursor& mesh, const std::vector<JsonCursor>& primitives) {
  const std::size_t expected = primitives.empty() ? 0 : target_count(primitives.front());
  for (const JsonCursor& primitive : primitives) {
    if (target_count(primitive) != expected) {
      primitive.fail("has not as many morph targets as the mesh's first primitive");
    }
  }
  const auto weights = mesh.find("weights");
  if (!weights) return;
  if (primitives.empty() || weights->size() != expected) {
    weights->fail("has not as many numbers as there are morph targets");
  }
}

}  // namespace

void check_meshes(const GltfCheckContext& context) {
  MeshChecker checker(context);
  for (const JsonCursor& mesh : context.all("meshes")) {
    const auto primitives = context.listed(mesh.get("primitives"));
    for (const JsonCursor& primitive : primitives) {
      checker.check_primitive(primitive);
    }
    context.note_if_wrong("morph targets are not used", [&] { check_targets(mesh, primitives); });
  }
}

}  // namespace amalgam::scene
