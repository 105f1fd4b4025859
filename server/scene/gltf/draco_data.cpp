#include <draco/compression/decode.h>

#include <cstring>

#include "scene/gltf/check/check_context.h"
#include "scene/gltf/check/limits.h"
#include "scene/gltf/compressed_data.h"

namespace amalgam::scene {
namespace {

// One new buffer, view and accessor. Gives the accessor's index.
int add_accessor(tinygltf::Model& model, tinygltf::Accessor accessor,
                 std::vector<unsigned char> data) {
  tinygltf::Buffer buffer;
  buffer.data = std::move(data);
  tinygltf::BufferView view;
  view.buffer = static_cast<int>(model.buffers.size());
  view.byteLength = buffer.data.size();
  accessor.bufferView = static_cast<int>(model.bufferViews.size());
  accessor.byteOffset = 0;
  accessor.sparse.isSparse = false;
  model.buffers.push_back(std::move(buffer));
  model.bufferViews.push_back(std::move(view));
  model.accessors.push_back(std::move(accessor));
  return static_cast<int>(model.accessors.size() - 1);
}

template <typename Number>
std::vector<unsigned char> values_of(const draco::Mesh& mesh,
                                     const draco::PointAttribute& attribute, int components) {
  const std::size_t element = sizeof(Number) * static_cast<std::size_t>(components);
  std::vector<unsigned char> bytes(mesh.num_points() * element);
  std::vector<Number> numbers(static_cast<std::size_t>(components));
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    const auto index = attribute.mapped_index(draco::PointIndex(i));
    if (!attribute.ConvertValue<Number>(index, static_cast<std::int8_t>(components),
                                        numbers.data())) {
      return {};
    }
    std::memcpy(bytes.data() + i * element, numbers.data(), element);
  }
  return bytes;
}

std::vector<unsigned char> values_of(const draco::Mesh& mesh,
                                     const draco::PointAttribute& attribute, int components,
                                     int type) {
  switch (type) {
    case kByte:
      return values_of<std::int8_t>(mesh, attribute, components);
    case kUnsignedByte:
      return values_of<std::uint8_t>(mesh, attribute, components);
    case kShort:
      return values_of<std::int16_t>(mesh, attribute, components);
    case kUnsignedShort:
      return values_of<std::uint16_t>(mesh, attribute, components);
    case kUnsignedInt:
      return values_of<std::uint32_t>(mesh, attribute, components);
    default:
      return values_of<float>(mesh, attribute, components);
  }
}

std::unique_ptr<draco::Mesh> decode(const JsonCursor& at, const tinygltf::Model& model) {
  const auto& view = model.bufferViews[static_cast<std::size_t>(at.get("bufferView").integer(0))];
  const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(data.data() + view.byteOffset), view.byteLength);
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) at.fail("its data are damaged: " + decoded.status().error_msg_string());
  auto mesh = std::move(decoded).value();
  return mesh;
}

// What the limits still leave. Primitives may share a block, and each decompresses it anew.
class Room {
 public:
  explicit Room(const DracoLimits& limits) : left_(limits) {}

  void take(const JsonCursor& at, const draco::Mesh& mesh) {
    take(at, mesh.num_points(), left_.vertices, "vertices");
    take(at, mesh.num_faces(), left_.triangles, "triangles");
  }
  void take_bytes(const JsonCursor& at, std::size_t bytes) {
    take(at, bytes, left_.bytes, "bytes");
  }

 private:
  static void take(const JsonCursor& at, std::size_t count, std::size_t& left, const char* what) {
    if (count > left) at.fail(std::string("the compressed primitives have too many ") + what);
    left -= count;
  }

  DracoLimits left_;
};

void decompress(const JsonCursor& at, Room& room, tinygltf::Model& model,
                tinygltf::Primitive& primitive) {
  const auto mesh = decode(at, model);
  room.take(at, *mesh);
  for (const auto& [name, id] : at.get("attributes").members()) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) id.fail("is no attribute of its primitive");
    const draco::PointAttribute* attribute =
        mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(id.integer(0)));
    if (!attribute) id.fail("there is no such attribute in the compressed data");
    // Of an attribute that nothing reads the check has only noted it.
    const auto index = static_cast<std::size_t>(found->second);
    if (index >= model.accessors.size()) continue;
    tinygltf::Accessor accessor = model.accessors[index];
    accessor.count = mesh->num_points();
    const int components =
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    room.take_bytes(id, accessor.count * static_cast<std::size_t>(components) *
                            static_cast<std::size_t>(component_bytes(accessor.componentType)));
    auto values = values_of(*mesh, *attribute, components, accessor.componentType);
    if (values.empty() && accessor.count > 0) id.fail("has values that its accessor cannot hold");
    found->second = add_accessor(model, std::move(accessor), std::move(values));
  }
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < mesh->num_faces(); ++i) {
    for (const draco::PointIndex& corner : mesh->face(draco::FaceIndex(i))) {
      indices.push_back(corner.value());
    }
  }
  tinygltf::Accessor accessor;
  accessor.type = TINYGLTF_TYPE_SCALAR;
  accessor.componentType = kUnsignedInt;
  accessor.count = indices.size();
  std::vector<unsigned char> bytes(indices.size() * sizeof(std::uint32_t));
  if (!bytes.empty()) std::memcpy(bytes.data(), indices.data(), bytes.size());
  primitive.indices = add_accessor(model, std::move(accessor), std::move(bytes));
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
}

}  // namespace

void decompress_draco(const JsonCursor& root, tinygltf::Model& model, const DracoLimits& limits) {
  Room room(limits);
  const auto meshes = root.find("meshes");
  if (!meshes) return;
  const auto mesh_cursors = meshes->items();
  for (std::size_t i = 0; i < mesh_cursors.size(); ++i) {
    const auto primitives = mesh_cursors[i].get("primitives").items();
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      const auto extensions = primitives[k].find("extensions");
      const auto at = extensions ? extensions->find("KHR_draco_mesh_compression") : std::nullopt;
      if (at) decompress(*at, room, model, model.meshes[i].primitives[k]);
    }
  }
}

}  // namespace amalgam::scene
