#include <meshoptimizer.h>

#include "scene/gltf/compressed_data.h"

namespace amalgam::scene {
namespace {

std::size_t size_of(const JsonCursor& holder, const char* name) {
  const auto at = holder.find(name);
  return at ? static_cast<std::size_t>(at->integer(0)) : 0;
}

// check_meshopt() has made sure of what the library only asserts.
std::vector<unsigned char> decode(const JsonCursor& at, const tinygltf::Model& model) {
  const auto& source = model.buffers[size_of(at, "buffer")].data;
  const std::size_t offset = size_of(at, "byteOffset"), bytes = size_of(at, "byteLength");
  if (source.size() < offset + bytes) at.fail("its buffer has no data");
  const std::size_t count = size_of(at, "count"), stride = size_of(at, "byteStride");
  const std::string& mode = at.get("mode").string();
  const auto filter = at.find("filter");
  std::vector<unsigned char> plain(count * stride);
  const unsigned char* from = source.data() + offset;
  int error = 0;
  if (mode == "ATTRIBUTES") {
    error = meshopt_decodeVertexBuffer(plain.data(), count, stride, from, bytes);
  } else if (mode == "TRIANGLES") {
    error = meshopt_decodeIndexBuffer(plain.data(), count, stride, from, bytes);
  } else {
    error = meshopt_decodeIndexSequence(plain.data(), count, stride, from, bytes);
  }
  if (error != 0) at.fail("its data are damaged");
  const std::string kind = filter ? filter->string() : "NONE";
  if (kind == "OCTAHEDRAL") meshopt_decodeFilterOct(plain.data(), count, stride);
  if (kind == "QUATERNION") meshopt_decodeFilterQuat(plain.data(), count, stride);
  if (kind == "EXPONENTIAL") meshopt_decodeFilterExp(plain.data(), count, stride);
  return plain;
}

}  // namespace

void decompress_meshopt(const JsonCursor& root, tinygltf::Model& model) {
  const auto views = root.find("bufferViews");
  if (!views) return;
  const auto cursors = views->items();
  for (std::size_t i = 0; i < cursors.size(); ++i) {
    const auto extensions = cursors[i].find("extensions");
    const auto at = extensions ? extensions->find("EXT_meshopt_compression") : std::nullopt;
    if (!at) continue;
    tinygltf::Buffer plain;
    plain.data = decode(*at, model);
    model.bufferViews[i].buffer = static_cast<int>(model.buffers.size());
    model.bufferViews[i].byteOffset = 0;
    model.buffers.push_back(std::move(plain));
  }
}

}  // namespace amalgam::scene
