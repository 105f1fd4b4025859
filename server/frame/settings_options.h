// The renderer's settings as options of a command line: what the options are called, and the words
// that give the same settings again. They are parsed by server/renderer_options.h.
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
inline constexpr const char* kRenderScale = "--render-scale";
inline constexpr const char* kTargetFps = "--target-fps";
inline constexpr const char* kCoarse = "--coarse";
inline constexpr const char* kThreads = "--threads";
}  // namespace option_names

// Options and their values for what differs from the defaults, a word each. Numbers are written so
// that reading them gives the same bits.
std::vector<std::string> settings_options(const RendererSettings& settings);

// What differs from the defaults and has no such option: "leave_out_tiles is false, ...". Empty if
// nothing does.
std::string settings_without_options(const RendererSettings& settings);

// The shortest text that is read as the same number.
std::string exact_text(float number);
std::string exact_text(double number);

}  // namespace amalgam::frame
