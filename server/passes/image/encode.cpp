#include "passes/image/encode.h"

#include <optional>
#include <utility>

#include "codec/jpeg.h"
#include "codec/jpeg_metadata.h"

namespace amalgam::passes {

graph::Handle<EncodedImage> add_encode_pass(graph::FrameGraph& graph, const EncodeInputs& in) {
  graph::Builder builder = graph.add_pass("encode");
  builder.needs(in.composite);
  builder.uses(in.coefficients);
  const auto out = builder.writes<EncodedImage>("composite jpeg");
  builder.runs([in, out](const graph::Access& access) {
    const Composite& composite = access.get(in.composite);
    std::optional<std::vector<std::byte>> patched;
    if (access.find(in.coefficients) != nullptr) {
      patched =
          codec::patch_jpeg(access.take(in.coefficients), composite.pixels, composite.changed);
    }
    if (patched) {
      access.set(out, EncodedImage{std::move(*patched)});
      return;
    }
    EncodedImage encoded{codec::encode_jpeg(composite.pixels, in.quality)};
    const auto* camera = in.camera ? std::get_if<std::vector<std::byte>>(in.camera) : nullptr;
    if (camera) codec::insert_metadata(encoded.jpeg, codec::jpeg_metadata(*camera));
    access.set(out, std::move(encoded));
  });
  return out;
}

}  // namespace amalgam::passes
