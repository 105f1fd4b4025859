#include "passes/encode.h"

#include "codec/jpeg.h"

namespace amalgam::passes {

graph::Handle<EncodedImage> add_encode_pass(graph::FrameGraph& graph,
                                            graph::Handle<Composite> composite, int quality) {
  graph::Builder builder = graph.add_pass("encode");
  builder.needs(composite);
  const auto out = builder.writes<EncodedImage>("composite jpeg");
  builder.runs([composite, out, quality](const graph::Access& access) {
    access.set(out, EncodedImage{codec::encode_jpeg(access.get(composite).pixels, quality)});
  });
  return out;
}

}  // namespace amalgam::passes
