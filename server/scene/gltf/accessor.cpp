#include "scene/gltf/accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "scene/gltf/check/check_context.h"
#include "scene/gltf/check/limits.h"
#include "scene/scene_error.h"

namespace amalgam::scene {
namespace {

const unsigned char* view_data(const tinygltf::Model& model, int view_index, std::size_t offset) {
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_index)];
  return model.buffers[static_cast<std::size_t>(view.buffer)].data.data() + view.byteOffset +
         offset;
}

template <typename T>
double load(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return static_cast<double>(value);
}

double load_number(const unsigned char* at, int component, bool normalized) {
  switch (component) {
    case kByte:
      return normalized ? std::max(load<std::int8_t>(at) / 127.0, -1.0) : load<std::int8_t>(at);
    case kUnsignedByte:
      return load<std::uint8_t>(at) / (normalized ? 255.0 : 1.0);
    case kShort:
      return normalized ? std::max(load<std::int16_t>(at) / 32767.0, -1.0) : load<std::int16_t>(at);
    case kUnsignedShort:
      return load<std::uint16_t>(at) / (normalized ? 65535.0 : 1.0);
    case kUnsignedInt:
      return load<std::uint32_t>(at);
    default:
      return load<float>(at);
  }
}

std::size_t components_of(const tinygltf::Accessor& accessor) {
  return static_cast<std::size_t>(
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

std::string path_of(std::size_t index) {
  return "accessors[" + std::to_string(index) + "]";
}

// Calls put(element, component, value) for every number of the accessor; sparse ones come last.
template <typename Put>
void for_each_number(const tinygltf::Model& model, std::size_t accessor_index, Put put) {
  const tinygltf::Accessor& accessor = model.accessors[accessor_index];
  const std::size_t components = components_of(accessor);
  const auto bytes = static_cast<std::size_t>(component_bytes(accessor.componentType));
  // Columns of small-component matrices are padded to 4 bytes; no accessor that is drawn holds any.
  const auto read_element = [&](std::size_t element, const unsigned char* at) {
    for (std::size_t c = 0; c < components; ++c) {
      put(element, c, load_number(at + c * bytes, accessor.componentType, accessor.normalized));
    }
  };
  if (accessor.bufferView >= 0) {
    const auto& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    const unsigned char* data = view_data(model, accessor.bufferView, accessor.byteOffset);
    const std::size_t stride = view.byteStride != 0 ? view.byteStride : components * bytes;
    for (std::size_t i = 0; i < accessor.count; ++i) read_element(i, data + i * stride);
  }
  if (!accessor.sparse.isSparse) return;
  const auto& sparse = accessor.sparse;
  const unsigned char* index = view_data(model, sparse.indices.bufferView,
                                         static_cast<std::size_t>(sparse.indices.byteOffset));
  const unsigned char* value = view_data(model, sparse.values.bufferView,
                                         static_cast<std::size_t>(sparse.values.byteOffset));
  const auto index_bytes = static_cast<std::size_t>(component_bytes(sparse.indices.componentType));
  for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
    const double at = load_number(index + i * index_bytes, sparse.indices.componentType, false);
    const auto element = static_cast<std::size_t>(at);
    if (element >= accessor.count) {
      throw SceneError(path_of(accessor_index) + ".sparse: index " + std::to_string(element) +
                       " is beyond the accessor");
    }
    read_element(element, value + i * components * bytes);
  }
}

}  // namespace

std::vector<float> read_floats(const tinygltf::Model& model, int accessor) {
  const auto index = static_cast<std::size_t>(accessor);
  const std::size_t components = components_of(model.accessors[index]);
  std::vector<float> values(model.accessors[index].count * components);
  for_each_number(model, index, [&](std::size_t element, std::size_t c, double value) {
    values[element * components + c] = static_cast<float>(value);
  });
  return values;
}

std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor) {
  const auto index = static_cast<std::size_t>(accessor);
  std::vector<std::uint32_t> values(model.accessors[index].count);
  for_each_number(model, index, [&](std::size_t element, std::size_t, double value) {
    values[element] = static_cast<std::uint32_t>(value);
  });
  return values;
}

std::vector<glm::vec3> read_vec3(const tinygltf::Model& model, int index) {
  const auto floats = read_floats(model, index);
  std::vector<glm::vec3> values(floats.size() / 3);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = {floats[3 * i], floats[3 * i + 1], floats[3 * i + 2]};
  }
  return values;
}

std::vector<glm::vec4> read_vec4(const tinygltf::Model& model, int index) {
  const auto floats = read_floats(model, index);
  std::vector<glm::vec4> values(floats.size() / 4);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = {floats[4 * i], floats[4 * i + 1], floats[4 * i + 2], floats[4 * i + 3]};
  }
  return values;
}

std::vector<glm::vec2> read_vec2(const tinygltf::Model& model, int index) {
  const auto floats = read_floats(model, index);
  std::vector<glm::vec2> values(floats.size() / 2);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = {floats[2 * i], floats[2 * i + 1]};
  return values;
}

namespace {

constexpr const char* kNotUsed = " (not used)";

// How an accessor's numbers are used; one that several attributes share has the last of theirs.
enum class Use { None, Repaired, Read, Position };

// With slack: exporters print bounds in fewer digits than the values have.
bool is_outside(double value, double low, double high) {
  const double slack = 1e-3 * std::abs(value) + 1e-3;
  return value < low - slack || value > high + slack;
}

void check_numbers(const tinygltf::Model& model, std::size_t index, Use use,
                   std::vector<std::string>& notes) {
  const tinygltf::Accessor& accessor = model.accessors[index];
  const std::string where = path_of(index) + ": element ";
  const auto& low = accessor.minValues;
  const auto& high = accessor.maxValues;
  bool is_noted = false;
  for_each_number(model, index, [&](std::size_t element, std::size_t c, double value) {
    if (!std::isfinite(value)) {
      const std::string what = where + std::to_string(element) + " is not finite";
      if (use != Use::None) throw SceneError(what);
      if (!is_noted) notes.push_back(what + kNotUsed);
      is_noted = true;
    }
    if (use == Use::Position && std::abs(value) > kMaxPosition) {
      throw SceneError(where + std::to_string(element) + " is farther than 1e12 from the origin");
    }
    if (is_noted || accessor.normalized || c >= low.size() || c >= high.size()) return;
    if (is_outside(value, low[c], high[c])) {
      notes.push_back(where + std::to_string(element) + " is outside min and max");
      is_noted = true;
    }
  });
}

Use use_of(const std::string& attribute) {
  if (attribute == "POSITION") return Use::Position;
  if (attribute == "NORMAL" || attribute == "TANGENT") return Use::Repaired;
  const bool is_read = attribute == "COLOR_0" || attribute.starts_with("TEXCOORD_");
  return is_read ? Use::Read : Use::None;
}

}  // namespace

void check_accessor_data(const tinygltf::Model& model, std::vector<std::string>& notes,
                         std::size_t max_unread) {
  std::vector<Use> uses(model.accessors.size(), Use::None);
  for (const auto& mesh : model.meshes) {
    for (const auto& primitive : mesh.primitives) {
      for (const auto& [name, accessor] : primitive.attributes) {
        const auto index = static_cast<std::size_t>(accessor);
        if (index < uses.size()) uses[index] = std::max(uses[index], use_of(name));
      }
    }
  }
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (uses[i] == Use::Repaired) continue;
    if (uses[i] != Use::None) {
      check_numbers(model, i, uses[i], notes);
      continue;
    }
    const std::size_t numbers = model.accessors[i].count * components_of(model.accessors[i]);
    if (notes.size() > kMaxNotes || numbers > max_unread) continue;
    max_unread -= numbers;
    try {
      check_numbers(model, i, uses[i], notes);
    } catch (const SceneError& caught) {
      notes.push_back(caught.what() + std::string(kNotUsed));
    }
  }
}

}  // namespace amalgam::scene
