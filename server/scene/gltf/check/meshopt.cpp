#include <array>

#include "scene/gltf/check/check_context.h"
#include "scene/gltf/check/limits.h"

// EXT_meshopt_compression: what libmeshoptimizer takes for granted.

namespace amalgam::scene {
namespace {

void check_filter(const JsonCursor& at, const std::string& mode, long long stride) {
  const auto filter = at.find("filter");
  const std::string kind = filter ? filter->string() : "NONE";
  if (kind == "NONE") return;
  bool fits = false;
  if (kind == "OCTAHEDRAL") fits = stride == 4 || stride == 8;
  if (kind == "QUATERNION") fits = stride == 8;
  if (kind == "EXPONENTIAL") fits = stride % 4 == 0;
  if (!fits || mode != "ATTRIBUTES") filter->fail("'" + kind + "' is unknown or cannot be here");
}

}  // namespace

void check_meshopt(const GltfCheckContext& context, const JsonCursor& at, long long length) {
  const JsonCursor buffer_at = at.get("buffer");
  const long long available = context.buffers[context.resolve(buffer_at, "buffers")].length;
  const auto offset_at = at.find("byteOffset");
  const long long offset = offset_at ? offset_at->integer(0) : 0;
  const long long bytes = at.get("byteLength").integer(1);
  if (offset > available || bytes > available - offset) at.fail("reaches beyond its buffer");
  const JsonCursor mode_at = at.get("mode");
  const std::string& mode = mode_at.string();
  const long long stride = at.get("byteStride").integer(2, 256);
  const long long count = at.get("count").integer(1, kMaxBufferBytes);
  const bool is_attributes = mode == "ATTRIBUTES", is_triangles = mode == "TRIANGLES";
  if (!is_attributes && !is_triangles && mode != "INDICES") mode_at.fail("is unknown");
  if (is_attributes ? stride % 4 != 0 : stride != 2 && stride != 4) {
    at.get("byteStride").fail("is none that " + mode + " can have");
  }
  if (is_triangles && count % 3 != 0) at.get("count").fail("is not a multiple of 3");
  if (count * stride != length) at.fail("has another length than its bufferView");
  check_filter(at, mode, stride);
}

}  // namespace amalgam::scene
