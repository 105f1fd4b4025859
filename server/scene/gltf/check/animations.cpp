#include <map>
#include <set>

#include "scene/gltf/check/check_context.h"

// Animations are not played. They are checked all the same: a wrong one may be a sign of a damaged
// file.

namespace amalgam::scene {
namespace {

struct Sampler {
  const AccessorFacts* input = nullptr;
  const AccessorFacts* output = nullptr;
  bool cubic = false;
};

Sampler check_sampler(const GltfCheckContext& context, const JsonCursor& at) {
  Sampler sampler;
  const JsonCursor input = at.get("input"), output = at.get("output");
  sampler.input = &context.accessors[context.resolve(input, "accessors")];
  sampler.output = &context.accessors[context.resolve(output, "accessors")];
  for (const auto& [cursor, accessor] :
       {std::pair(&input, sampler.input), {&output, sampler.output}}) {
    if (accessor->view && context.views[*accessor->view].stride)
      cursor->fail("cannot have a byteStride");
  }
  if (sampler.input->type != "SCALAR" || sampler.input->component != kFloat) {
    input.fail("times are not float scalars");
  }
  if (!sampler.input->has_bounds) input.fail("its accessor has no min and max");
  if (const auto interpolation = at.find("interpolation")) {
    const std::string& kind = interpolation->string();
    sampler.cubic = kind == "CUBICSPLINE";
    if (!sampler.cubic && kind != "LINEAR" && kind != "STEP") interpolation->fail("is unknown");
  }
  if (sampler.cubic && sampler.input->count < 2) input.fail("a cubic spline needs two times");
  return sampler;
}

std::size_t morph_targets(const GltfCheckContext& context, const JsonCursor& node) {
  const auto mesh = node.find("mesh");
  if (!mesh) return 0;
  const JsonCursor& used = context.all("meshes")[context.resolve(*mesh, "meshes")];
  const auto first = used.get("primitives").front();
  const auto targets = first ? first->find("targets") : std::nullopt;
  return targets ? targets->size() : 0;
}

void check_output(const GltfCheckContext& context, const JsonCursor& channel,
                  const Sampler& sampler, const std::string& path,
                  const std::optional<std::size_t>& node) {
  const std::string& type = sampler.output->type;
  const bool is_float = sampler.output->component == kFloat;
  const bool is_number = is_float || sampler.output->normalized;
  long long elements = 1;
  bool fits = false;
  if (path == "translation" || path == "scale") {
    fits = type == "VEC3" && is_float;
  } else if (path == "rotation") {
    fits = type == "VEC4" && is_number;
  } else {
    fits = type == "SCALAR" && is_number;
    elements =
        node ? static_cast<long long>(morph_targets(context, context.all("nodes")[*node])) : 0;
    if (node && elements == 0) channel.fail("animates weights of a node without morph targets");
  }
  if (!fits) channel.fail("its output accessor has a format that " + path + " cannot have");
  const long long expected = sampler.input->count * elements * (sampler.cubic ? 3 : 1);
  if (elements != 0 && sampler.output->count != expected) {
    channel.fail("its output has not as many elements as its input asks for");
  }
}

}  // namespace

void check_animations(const GltfCheckContext& context) {
  for (const JsonCursor& animation : context.all("animations")) {
    std::vector<Sampler> samplers;
    for (const JsonCursor& at : context.listed(animation.get("samplers"))) {
      samplers.push_back(check_sampler(context, at));
    }
    std::set<std::pair<std::size_t, std::string>> targets;
    for (const JsonCursor& channel : context.listed(animation.get("channels"))) {
      const JsonCursor sampler_at = channel.get("sampler");
      const auto sampler = static_cast<std::size_t>(sampler_at.integer(0));
      if (sampler >= samplers.size()) sampler_at.fail("there is no such sampler");
      const JsonCursor target = channel.get("target");
      const std::string& path = target.get("path").string();
      if (path != "translation" && path != "rotation" && path != "scale" && path != "weights") {
        context.note(target, "animates '" + path + "', which is unknown");
        continue;
      }
      std::optional<std::size_t> node;
      if (const auto node_at = target.find("node")) {
        node = context.resolve(*node_at, "nodes");
        if (!targets.emplace(*node, path).second)
          channel.fail("has the same target as another channel");
        if (path != "weights" && context.all("nodes")[*node].find("matrix")) {
          node_at->fail("a node with a matrix cannot be animated");
        }
      }
      check_output(context, channel, samplers[sampler], path, node);
    }
  }
}

}  // namespace amalgam::scene
