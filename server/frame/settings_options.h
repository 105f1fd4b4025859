// The renderer's settings as command-line options: their names, and the conversion from settings to
// options. server/renderer_options.h converts options to settings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frame/renderer_settings.h"

namespace amalgam::frame {

namespace option_names {
inline constexpr const char* kRenderer = "--renderer";
inline constexpr const char* kSamples = "--samples";
inline constexpr const char* kShadowEdges = "--shadow-edges";
inline constexpr const char* kMaxDepth = "--max-depth";
inline constexpr const char* kImportanceCutoff = "--importance-cutoff";
inline constexpr const char* kFresnel = "--fresnel";
inline constexpr const char* kEnvLights = "--env-lights";
inline constexpr const char* kExposure = "--exposure";
inline constexpr const char* kMeter = "--meter";
inline constexpr const char* kWhiteBalance = "--white-balance";
inline constexpr const char* kToneMap = "--tone-map";
inline constexpr const char* kRealSurfaces = "--real-surfaces";
inline constexpr const char* kRenderScale = "--render-scale";
inline constexpr const char* kTargetFps = "--target-fps";
inline constexpr const char* kCoarse = "--coarse";
inline constexpr const char* kThreads = "--threads";
}  // namespace option_names

// Options and values of the settings that differ from the defaults, one word each. Parsing them
// gives the same settings to the bit.
std::vector<std::string> settings_options(const RendererSettings& settings);

// The settings that differ from the defaults and have no such option: "leave_out_tiles is false,
// ...". Empty if there are none.
std::string settings_without_options(const RendererSettings& settings);

// The shortest text that parses to the same number.
std::string exact_text(float number);
std::string exact_text(double number);

}  // namespace amalgam::frame
