// Shared by the parts of the glTF check: the document's collections, and resolving references to
// them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf/check/json_value.h"
#include "scene/scene_error.h"

namespace amalgam::scene {

// glTF's numbers for component types.
enum ComponentType : int {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126,
};

struct BufferFacts {
  long long length = 0;      // bytes
  bool is_fallback = false;  // what it would hold is compressed in another one
};

struct ViewFacts {
  long long length = 0;             // bytes
  std::optional<long long> stride;  // bytes between elements, if said
};

struct AccessorFacts {
  int component = kFloat;
  std::string type;  // SCALAR, VEC2, ...
  long long count = 0;
  long long offset = 0;  // bytes into its view
  bool normalized = false;
  bool has_bounds = false;
  bool has_data = false;  // a view, or sparse values
  std::optional<std::size_t> view;
};

class GltfCheckContext {
 public:
  GltfCheckContext(const JsonCursor& document, std::vector<std::string>& found_notes);

  // The objects of a root collection such as "accessors"; empty if it is left out.
  const std::vector<JsonCursor>& all(std::string_view collection) const;

  // The index that a reference holds; fails if the collection has no such element.
  std::size_t resolve(const JsonCursor& reference, std::string_view collection) const;

  // The elements of a list. An empty one is against glTF's schema but says nothing: noted.
  std::vector<JsonCursor> listed(const JsonCursor& list) const;

  void note(const JsonCursor& where, const std::string& what) const;

  // Notes what check() throws, followed by why: for what the picture does not hang on.
  template <typename Check>
  void note_if_wrong(const char* why, Check check) const {
    try {
      check();
    } catch (const SceneError& caught) {
      add_note(std::string(caught.what()) + " (" + why + ")");
    }
  }

  bool uses(std::string_view extension) const;  // declared in extensionsUsed

  JsonCursor root;
  std::vector<BufferFacts> buffers;      // filled by check_buffers()
  std::vector<ViewFacts> views;          // filled by check_buffer_views()
  std::vector<AccessorFacts> accessors;  // filled by check_accessors()

 private:
  void add_note(std::string text) const;

  std::map<std::string, std::vector<JsonCursor>, std::less<>> collections_;
  std::set<std::string, std::less<>> used_;  // extensions
  std::vector<std::string>& notes_;
};

int component_bytes(int component);          // 0 for an unknown component type
int component_count(std::string_view type);  // 0 for an unknown type

// The parts, in the order in which they must run. Each throws SceneError.
void check_asset(const GltfCheckContext& context);
void check_extensions(const GltfCheckContext& context);
void check_buffers(GltfCheckContext& context, std::optional<std::size_t> binary_bytes);
void check_buffer_views(GltfCheckContext& context);
void check_meshopt(const GltfCheckContext& context, const JsonCursor& view, long long length);
void check_accessors(GltfCheckContext& context);
void check_textures(const GltfCheckContext& context);
void check_materials(const GltfCheckContext& context);
void check_meshes(const GltfCheckContext& context);
void check_nodes(const GltfCheckContext& context);
void check_skins(const GltfCheckContext& context);
void check_cameras(const GltfCheckContext& context);
void check_animations(const GltfCheckContext& context);

}  // namespace amalgam::scene
