#include <array>

#include "scene/gltf/check/check_context.h"
#include "scene/gltf/check/limits.h"
#include "scene/gltf/check/texture_source.h"
#include "scene/gltf/check/uri.h"

namespace amalgam::scene {
namespace {

void check_texture_info(const GltfCheckContext& context, const JsonCursor& material,
                        std::string_view name) {
  const auto info = material.find(name);
  if (!info) return;
  context.resolve(info->get("index"), "textures");
  if (const auto set = info->find("texCoord")) set->integer(0, 15);
}

// Exporters round, or convert colors in float: a hair outside is clamped when the material is read.
void check_number(const GltfCheckContext& context, const JsonCursor& at, double low, double high) {
  constexpr double kHair = 1e-2;
  const double value = at.number();
  if (value >= low && value <= high) return;
  if (!(value >= low - kHair && value <= high + kHair)) at.number(low, high);
  context.note(at, "is a little outside its range, clamped");
}

void check_factors(const GltfCheckContext& context, const JsonCursor& material,
                   std::string_view name, std::size_t count, double high = 1.0) {
  const auto factors = material.find(name);
  if (!factors) return;
  factors->numbers(count);
  for (const JsonCursor& factor : factors->items()) check_number(context, factor, 0.0, high);
}

void check_factor(const GltfCheckContext& context, const JsonCursor& material,
                  std::string_view name, double low, double high) {
  if (const auto factor = material.find(name)) check_number(context, *factor, low, high);
}

void check_material_extensions(const GltfCheckContext& context, const JsonCursor& extensions) {
  if (const auto at = extensions.find("KHR_materials_transmission")) {
    check_factor(context, *at, "transmissionFactor", 0.0, 1.0);
    check_texture_info(context, *at, "transmissionTexture");
  }
  if (const auto at = extensions.find("KHR_materials_ior")) {
    const auto ior = at->find("ior");
    // 0 is the specification's "infinite" backward compatibility mode.
    if (ior && ior->number(0.0, 100.0) != 0.0) {
      if (ior->number() < 0.99) ior->fail("is below 1");
      check_number(context, *ior, 1.0, 100.0);
    }
  }
  if (const auto at = extensions.find("KHR_materials_volume")) {
    check_factor(context, *at, "thicknessFactor", 0.0, kMaxQuantity);
    check_texture_info(context, *at, "thicknessTexture");
    check_factors(context, *at, "attenuationColor", 3);
    if (const auto distance = at->find("attenuationDistance")) {
      if (distance->number() < 0.0) distance->fail("is below 0");
      if (distance->number() == 0.0) context.note(*distance, "is 0, read as without absorption");
    }
  }
  if (const auto at = extensions.find("KHR_materials_emissive_strength")) {
    check_factor(context, *at, "emissiveStrength", 0.0, kMaxQuantity);
  }
}

}  // namespace

void check_textures(const GltfCheckContext& context) {
  for (const JsonCursor& image : context.all("images")) {
    const auto uri = image.find("uri"), view = image.find("bufferView"),
               mime = image.find("mimeType");
    if (uri && view) image.fail("has a uri and a bufferView");
    if (!uri && !view) context.note(image, "has neither a uri nor a bufferView");
    if (mime) mime->string();
    if (uri) check_image_uri(context, *uri);
    if (view) {
      // The bytes themselves say what they are.
      if (!mime) context.note(image, "a bufferView without a mimeType");
      const ViewFacts& bytes = context.views[context.resolve(*view, "bufferViews")];
      if (bytes.stride) context.note(*view, "a view with byteStride cannot hold a picture");
      if (bytes.length == 0) view->fail("an empty view cannot hold a picture");
    }
  }
  for (const JsonCursor& sampler : context.all("samplers")) {
    for (const char* wrap : {"wrapS", "wrapT"}) {
      const auto at = sampler.find(wrap);
      if (!at) continue;
      const long long mode = at->integer(0);
      if (mode != 33071 && mode != 33648 && mode != 10497) at->fail("is not a wrapping mode");
    }
    for (const char* filter : {"magFilter", "minFilter"}) {
      const auto at = sampler.find(filter);
      if (!at) continue;
      const long long mode = at->integer(0);
      const bool plain = mode == 9728 || mode == 9729, mipmapped = mode >= 9984 && mode <= 9987;
      // Textures are filtered trilinearly, whatever it says.
      if (!plain && !(mipmapped && filter[1] == 'i')) context.note(*at, "is not a filter");
    }
  }
  for (const JsonCursor& texture : context.all("textures")) {
    if (const auto sampler = texture.find("sampler")) context.resolve(*sampler, "samplers");
    if (const auto source = texture.find("source")) context.resolve(*source, "images");
    const auto source = texture_source(texture);
    const std::size_t images = context.all("images").size();
    if (source && *source >= images) {
      texture.fail("there is no images[" + std::to_string(*source) + "] (the file has " +
                   std::to_string(images) + ")");
    }
  }
}

void check_materials(const GltfCheckContext& context) {
  for (const JsonCursor& material : context.all("materials")) {
    if (const auto pbr = material.find("pbrMetallicRoughness")) {
      check_factors(context, *pbr, "baseColorFactor", 4);
      check_factor(context, *pbr, "metallicFactor", 0.0, 1.0);
      check_factor(context, *pbr, "roughnessFactor", 0.0, 1.0);
      check_texture_info(context, *pbr, "baseColorTexture");
      check_texture_info(context, *pbr, "metallicRoughnessTexture");
    }
    for (const char* name : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
      check_texture_info(context, material, name);
    }
    if (const auto normal = material.find("normalTexture")) {
      const auto scale = normal->find("scale");
      if (scale) scale->number(-kMaxNormalScale, kMaxNormalScale);
    }
    // Older exporters wrote bright lamps so, before there was KHR_materials_emissive_strength.
    check_factors(context, material, "emissiveFactor", 3, kMaxQuantity);
    if (const auto emissive = material.find("emissiveFactor")) {
      for (const double factor : emissive->numbers(3)) {
        if (factor > 1.0) context.note(*emissive, "is above 1");
      }
    }
    if (const auto mode = material.find("alphaMode")) {
      const std::string& text = mode->string();
      if (text != "OPAQUE" && text != "MASK" && text != "BLEND") {
        mode->fail("'" + text + "' is none of OPAQUE, MASK, BLEND");
      }
    }
    check_factor(context, material, "alphaCutoff", 0.0, kMaxQuantity);
    if (const auto sided = material.find("doubleSided")) sided->boolean();
    if (const auto extensions = material.find("extensions")) {
      check_material_extensions(context, *extensions);
    }
  }
}

void check_cameras(const GltfCheckContext& context) {
  for (const JsonCursor& camera : context.all("cameras")) {
    const JsonCursor type = camera.get("type");
    const std::string& kind = type.string();
    if (kind != "perspective" && kind != "orthographic") {
      type.fail("is neither perspective nor orthographic");
    }
    if (camera.find("perspective") && camera.find("orthographic")) camera.fail("is of both types");
    const JsonCursor at = camera.get(kind);
    const double near = at.get("znear").number();
    const bool perspective = kind == "perspective";
    if (near < 0.0 || (perspective && near == 0.0)) at.get("znear").fail("is not above 0");
    const auto far = perspective ? at.find("zfar") : std::optional(at.get("zfar"));
    if (far && !(far->number() > near)) far->fail("is not above znear");
    for (const char* name : {"yfov", "xmag", "ymag"}) {
      if ((name[0] == 'y' && name[1] == 'f') != perspective) continue;
      const double value = at.get(name).number();
      if (value == 0.0 || (perspective && value < 0.0)) at.get(name).fail("is not above 0");
    }
    if (const auto ratio = at.find("aspectRatio")) {
      if (!(ratio->number() > 0.0)) ratio->fail("is not above 0");
    }
  }
}

}  // namespace amalgam::scene
