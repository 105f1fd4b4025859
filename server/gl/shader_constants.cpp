#include "gl/shader_constants.h"

#include <array>
#include <charconv>
#include <string_view>
#include <type_traits>

#include "gl/shader_interface.h"
#include "scene/light/light.h"
#include "scene/material.h"
#include "scene/scene.h"
#include "scene/texture_lookup.h"

namespace amalgam::gl {
namespace {

// The shortest decimal that reads back as the same value.
template <typename T>
std::string digits(T value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

// Unsigned numbers and enumerators become uint, double becomes float.
template <typename T>
std::string constant(std::string_view name, T value) {
  const std::string begin(name);
  if constexpr (std::is_enum_v<T>) {
    return constant(name, static_cast<unsigned>(value));
  } else if constexpr (std::is_floating_point_v<T>) {
    return "const float " + begin + " = " + digits(value) + ";\n";
  } else if constexpr (std::is_unsigned_v<T>) {
    return "const uint " + begin + " = " + digits(value) + "u;\n";
  } else {
    return "const int " + begin + " = " + digits(value) + ";\n";
  }
}

#define AMALGAM_CONSTANT(name) constant(#name, name)

std::string places() {
  return AMALGAM_CONSTANT(kFrameBinding) + AMALGAM_CONSTANT(kSrgbTableBinding) +
         AMALGAM_CONSTANT(kSurfaceBinding) + AMALGAM_CONSTANT(kLightsBinding) +
         AMALGAM_CONSTANT(kShadowLayerBinding) + AMALGAM_CONSTANT(kFaceNormalsBinding) +
         AMALGAM_CONSTANT(kSecondUvAreasBinding) + AMALGAM_CONSTANT(kBaseColorUnit) +
         AMALGAM_CONSTANT(kMaskUnit) + AMALGAM_CONSTANT(kShadowMapUnit) +
         AMALGAM_CONSTANT(kTileLightsUnit) + AMALGAM_CONSTANT(kMetallicRoughnessUnit) +
         AMALGAM_CONSTANT(kEmissiveUnit) + AMALGAM_CONSTANT(kTransmissionUnit) +
         AMALGAM_CONSTANT(kNormalUnit) + AMALGAM_CONSTANT(kPositionAttribute) +
         AMALGAM_CONSTANT(kNormalAttribute) + AMALGAM_CONSTANT(kUvAttribute) +
         AMALGAM_CONSTANT(kColorAttribute) + AMALGAM_CONSTANT(kTangentAttribute) +
         AMALGAM_CONSTANT(kSecondUvAttribute) + AMALGAM_CONSTANT(kLightCountLocation) +
         AMALGAM_CONSTANT(kShadowMapsPresentLocation) + AMALGAM_CONSTANT(kMaskStepLocation) +
         AMALGAM_CONSTANT(kSamplesOfTileLocation) + AMALGAM_CONSTANT(kMixedOutput) +
         AMALGAM_CONSTANT(kWhiteSurfacesLocation) + AMALGAM_CONSTANT(kRealOutput);
}

std::string contents_of_buffers() {
  return AMALGAM_CONSTANT(kMaxLights) + AMALGAM_CONSTANT(kFewSuns) + AMALGAM_CONSTANT(kCubeSides) +
         AMALGAM_CONSTANT(kSrgbTableSize) + AMALGAM_CONSTANT(kSecondUvsBit) +
         AMALGAM_CONSTANT(kWrapBits) + AMALGAM_CONSTANT(kMapSizeBits) +
         AMALGAM_CONSTANT(kVirtualFlag);
}

std::string kinds() {
  return constant("kDirectionalLight", scene::Light::Kind::Directional) +
         constant("kSpotLight", scene::Light::Kind::Spot) +
         constant("kWrapRepeat", scene::Wrap::Repeat) + constant("kWrapClamp", scene::Wrap::Clamp) +
         constant("kBaseColorSlot", scene::TextureSlot::BaseColor) +
         constant("kMetallicRoughnessSlot", scene::TextureSlot::MetallicRoughness) +
         constant("kEmissiveSlot", scene::TextureSlot::Emissive) +
         constant("kTransmissionSlot", scene::TextureSlot::Transmission) +
         constant("kNormalSlot", scene::TextureSlot::Normal) +
         constant("kRealOpaque", CasterClass::RealOpaque) +
         constant("kVirtualOpaque", CasterClass::VirtualOpaque) +
         constant("kRealGlass", CasterClass::RealGlass) +
         constant("kVirtualGlass", CasterClass::VirtualGlass);
}

std::string limits_of_formulas() {
  using namespace scene;
  return AMALGAM_CONSTANT(kNearPlane) + AMALGAM_CONSTANT(kLeastShadowCosine) +
         AMALGAM_CONSTANT(kMinLightDistance) + AMALGAM_CONSTANT(kMinConeWidth) +
         AMALGAM_CONSTANT(kDielectricF0) + AMALGAM_CONSTANT(kMinSquaredAlpha) +
         AMALGAM_CONSTANT(kMaxPhongExponent) + AMALGAM_CONSTANT(kMinFootprintCosine) +
         AMALGAM_CONSTANT(kMaxTexelPlace) + AMALGAM_CONSTANT(kMinTangentShare);
}

#undef AMALGAM_CONSTANT

}  // namespace

std::string shader_constants() {
  return places() + contents_of_buffers() + kinds() + limits_of_formulas();
}

}  // namespace amalgam::gl
