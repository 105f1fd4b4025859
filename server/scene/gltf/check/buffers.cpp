#include "scene/gltf/check/check_context.h"
#include "scene/gltf/check/limits.h"
#include "scene/gltf/check/uri.h"

// Bytes: that every buffer, view and accessor lies inside what holds it, so that nothing later can
// read beyond it.

namespace amalgam::scene {
namespace {

constexpr const char* kMeshopt = "EXT_meshopt_compression";

std::optional<JsonCursor> meshopt_of(const JsonCursor& holder) {
  const auto extensions = holder.find("extensions");
  return extensions ? extensions->find(kMeshopt) : std::nullopt;
}

void check_sparse(const GltfCheckContext& context, const JsonCursor& sparse,
                  const AccessorFacts& accessor) {
  const JsonCursor count_at = sparse.get("count");
  const long long count = count_at.integer(0);
  if (count == 0) return context.note(count_at, "is 0");
  if (count > accessor.count) count_at.fail("more sparse elements than the accessor has");
  const auto check_part = [&](const char* name, int component, int components) {
    const JsonCursor part = sparse.get(name);
    const JsonCursor view_at = part.get("bufferView");
    const ViewFacts& view = context.views[context.resolve(view_at, "bufferViews")];
    if (view.stride) view_at.fail("a view with byteStride cannot hold sparse data");
    const auto offset_at = part.find("byteOffset");
    const long long offset = offset_at ? offset_at->integer(0) : 0;
    if (offset % component_bytes(component) != 0) context.note(*offset_at, "is not aligned");
    if (offset + count * component_bytes(component) * components > view.length) {
      part.fail("sparse data reach beyond their bufferView");
    }
  };
  const JsonCursor index_type = sparse.get("indices").get("componentType");
  const int type = static_cast<int>(index_type.integer(0));
  if (type != kUnsignedByte && type != kUnsignedShort && type != kUnsignedInt) {
    index_type.fail("is not an unsigned integer type");
  }
  check_part("indices", type, 1);
  check_part("values", accessor.component, component_count(accessor.type));
}

void check_inside_view(const GltfCheckContext& context, const JsonCursor& at,
                       const AccessorFacts& accessor) {
  const ViewFacts& view = context.views[*accessor.view];
  const long long component = component_bytes(accessor.component);
  const long long element = component * component_count(accessor.type);
  // Numbers are copied byte by byte, so that alignment does not matter.
  if (accessor.offset % component != 0)
    context.note(at, "byteOffset is not aligned to its component type");
  if (view.stride && *view.stride < element) {
    at.fail("elements are longer than the bufferView's byteStride");
  }
  const long long stride = view.stride.value_or(element);
  if (stride % component != 0) context.note(at, "byteStride is not aligned to its component type");
  if (accessor.count == 0) return;
  // In this order nothing can overflow: counts are below 2^53 only on paper.
  if (accessor.offset > view.length || element > view.length - accessor.offset ||
      accessor.count - 1 > (view.length - accessor.offset - element) / stride) {
    at.fail("reaches beyond its bufferView of " + std::to_string(view.length) + " bytes");
  }
}

void check_bounds(const GltfCheckContext& context, const JsonCursor& at, AccessorFacts& accessor) {
  const auto min = at.find("min"), max = at.find("max");
  const auto components = static_cast<std::size_t>(component_count(accessor.type));
  context.note_if_wrong("bounds are not used", [&] {
    if (min) min->numbers(components);
    if (max) max->numbers(components);
  });
  accessor.has_bounds = min && max;
}

}  // namespace

int component_bytes(int component) {
  switch (component) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

int component_count(std::string_view type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  if (type == "VEC4" || type == "MAT2") return 4;
  if (type == "MAT3") return 9;
  if (type == "MAT4") return 16;
  return 0;
}

void check_buffers(GltfCheckContext& context, std::optional<std::size_t> binary_bytes) {
  const auto& buffers = context.all("buffers");
  long long total = 0;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const JsonCursor length_at = buffers[i].get("byteLength");
    const long long length = length_at.integer(0, kMaxBufferBytes);
    if (length == 0) context.note(buffers[i], "is empty");
    total += length;
    if (total > kMaxBufferBytes) length_at.fail("the buffers together are larger than 512 MiB");
    const auto uri = buffers[i].find("uri");
    const bool is_compressed = meshopt_of(buffers[i]).has_value();
    context.buffers.push_back({length, !uri && is_compressed});
    if (uri) {
      check_buffer_uri(context, *uri, length);
    } else if (is_compressed || length == 0) {
      continue;  // what it would hold is compressed in another one
    } else if (i != 0 || !binary_bytes) {
      buffers[i].fail("has no uri, and there is no GLB chunk for it");
    } else if (length > static_cast<long long>(*binary_bytes)) {
      length_at.fail("says " + std::to_string(length) + " bytes and the GLB chunk has " +
                     std::to_string(*binary_bytes));
    }
  }
}

void check_buffer_views(GltfCheckContext& context) {
  long long decompressed = 0;
  for (const JsonCursor& at : context.all("bufferViews")) {
    const std::size_t buffer = context.resolve(at.get("buffer"), "buffers");
    const long long available = context.buffers[buffer].length;
    ViewFacts view;
    view.length = at.get("byteLength").integer(0, kMaxBufferBytes);
    // Against the specification, but exporters write them for empty tables of metadata. Whatever
    // reads one, accessor or picture, is refused for that.
    if (view.length == 0) context.note(at, "is empty");
    const auto offset_at = at.find("byteOffset");
    const long long offset = offset_at ? offset_at->integer(0) : 0;
    if (offset > available || view.length > available - offset) {
      at.fail("reaches beyond its buffer of " + std::to_string(available) + " bytes");
    }
    if (const auto stride = at.find("byteStride")) {
      const long long bytes = stride->integer(0, kMaxBufferBytes);
      if (bytes > 0) view.stride = bytes;  // glTF 1 wrote 0 for "close together"
      if (bytes < 4 || bytes > 252 || bytes % 4 != 0)
        context.note(*stride, "is not a multiple of 4 within 4 and 252");
      if (bytes > view.length) context.note(*stride, "is longer than the bufferView");
    }
    const auto compressed = meshopt_of(at);
    if (compressed) {
      check_meshopt(context, *compressed, view.length);
      decompressed += view.length;
      if (decompressed > kMaxBufferBytes) at.fail("decompressed data are larger than 512 MiB");
    } else if (context.buffers[buffer].is_fallback) {
      at.fail("lies in a buffer without data");
    }
    context.views.push_back(view);
  }
}

void check_accessors(GltfCheckContext& context) {
  for (const JsonCursor& at : context.all("accessors")) {
    AccessorFacts accessor;
    const JsonCursor component_at = at.get("componentType"), type_at = at.get("type");
    accessor.component = static_cast<int>(component_at.integer(0, 65535));
    if (component_bytes(accessor.component) == 0) component_at.fail("is not a component type");
    accessor.type = type_at.string();
    if (component_count(accessor.type) == 0) type_at.fail("'" + accessor.type + "' is not a type");
    accessor.count = at.get("count").integer(0, kMaxAccessorElements);
    if (accessor.count == 0) context.note(at, "has no elements");
    if (const auto normalized = at.find("normalized")) {
      accessor.normalized = normalized->boolean();
      if (accessor.normalized &&
          (accessor.component == kFloat || accessor.component == kUnsignedInt)) {
        context.note(*normalized, "only 8 and 16 bit integers can be normalized");
        accessor.normalized = false;
      }
    }
    const auto offset = at.find("byteOffset"), view = at.find("bufferView");
    if (offset) accessor.offset = offset->integer(0, kMaxBufferBytes);
    if (offset && !view) context.note(*offset, "stands without a bufferView");
    if (view) {
      accessor.view = context.resolve(*view, "bufferViews");
      check_inside_view(context, at, accessor);
    }
    check_bounds(context, at, accessor);
    if (const auto sparse = at.find("sparse")) check_sparse(context, *sparse, accessor);
    accessor.has_data = view || at.find("sparse");
    context.accessors.push_back(std::move(accessor));
  }
}

}  // namespace amalgam::scene
