// Each number that C++ and GLSL share is written in C++ alone (gl/shader_constants.h).
#include "gl/shader_constants.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace amalgam::gl {
namespace {

// By file name, without comments and preprocessor lines.
std::map<std::string, std::string> shader_files() {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(AMALGAM_SOURCE_DIR "/shaders")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".glsl" && extension != ".vert" && extension != ".frag") continue;
    std::ifstream file(entry.path());
    std::string& text = files[entry.path().filename().string()];
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with("#")) continue;
      text += line.substr(0, line.find("//")) + "\n";
    }
  }
  return files;
}

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i)
    found.push_back(i->str(i->size() > 1 ? 1 : 0));
  return found;
}

TEST(ShaderConstants, AreWrittenAsGlslHasThem) {
  const std::string constants = shader_constants();
  for (const char* line :
       {"const uint kMaxLights = 512u;\n", "const int kMaskStepLocation = 3;\n",
        "const float kNearPlane = 1e-06;\n", "const float kMinLightDistance = 1e-06;\n",
        "const uint kSpotLight = 2u;\n", "const uint kVirtualGlass = 3u;\n"}) {
    EXPECT_NE(constants.find(line), std::string::npos) << line << constants;
  }
}

TEST(ShaderConstants, AreAllUsedByShaders) {
  std::string all;
  for (const auto& [name, text] : shader_files()) all += text;
  for (const std::string& name : matches(shader_constants(), std::regex("(k[A-Z]\\w*) ="))) {
    EXPECT_TRUE(std::regex_search(all, std::regex("\\b" + name + "\\b"))) << name;
  }
}

// What is left in the shaders are numbers that mean themselves, such as a half or the largest byte,
// and those that C++ has no part in.
TEST(ShaderConstants, AreSpelledInNoShader) {
  const std::set<std::string> plain{"0",  "1",  "2",   "3",   "0u",  "1u",  "2u",
                                    "3u", "4u", "0.0", "0.5", "1.0", "2.0", "255.0"};
  const std::map<std::string, std::set<std::string>> own{
      // Which of the few suns, written out one by one.
      {"shade_diffuse.frag", {"4", "5", "6", "7", "5u", "6u", "7u"}},
      {"phong.glsl", {"3.14159265358979"}},
      // The last side of a cube; roundings and limits of look-ups.
      {"shadow.glsl", {"5u", "1e-6", "1e-5", "0.999", "65536.0"}}};
  const std::regex number(R"((?:^|[^\w.])(\d(?:[eE][-+]\d|[\w.])*))");
  for (const auto& [name, text] : shader_files()) {
    for (const std::string& literal : matches(text, number)) {
      const bool is_own = own.contains(name) && own.at(name).contains(literal);
      EXPECT_TRUE(plain.contains(literal) || is_own)
          << name << " spells " << literal << ": give it a name in gl/shader_constants.cpp";
    }
  }
}

// Nor does a small number stand there for a place, a kind or a bit.
TEST(ShaderConstants, NamePlacesKindsAndBits) {
  const std::regex spelled(R"((?:binding|location) *= *\d)"
                           R"(|\b(?:kind|wrap|slot|layer_count) *[!=]= *\d)"
                           R"(|(?:_flags|_present|textures|wraps) *(?:&|>>) *\d)"
                           R"(|\bk[A-Z]\w* *= *\d+u)");
  for (const auto& [name, text] : shader_files()) {
    for (const std::string& found : matches(text, spelled)) ADD_FAILURE() << name << ": " << found;
  }
}

}  // namespace
}  // namespace amalgam::gl
