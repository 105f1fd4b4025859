#include "passes/image/encode.h"

#include <optional>
#include <utility>

#include "codec/jpeg.h"

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
    access.set(out, EncodedImage{patched ? std::move(*patched)
                                         : codec::encode_jpeg(composite.pixels, in.quality)});
  });
  return out;
}

}  // namespace amalgam::passes
