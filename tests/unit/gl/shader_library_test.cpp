#include "gl/shader_library.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "gl/egl_context.h"
#include "shaders/shader_sources.h"
#include "support/scene_builders.h"

namespace amalgam::gl {
namespace {

using namespace test_support;

TEST(ShaderLibrary, CompilesForEverySetOfFeatures) {
  const EglContext context;
  // Nothing, everything, and each alone: branches do not interact.
  for (const unsigned bits : {0u, 31u, 1u, 2u, 4u, 8u, 16u}) {
    const ShaderFeatures features{.textures = (bits & 1) != 0,
                                  .real_opaque = (bits & 2) != 0,
                                  .virtual_opaque = (bits & 4) != 0,
                                  .real_glass = (bits & 8) != 0,
                                  .virtual_glass = (bits & 16) != 0};
    EXPECT_NO_THROW(ShaderLibrary{features}) << bits;
  }
}

TEST(ShaderProgram, SaysWhichFileIsBrokenAndHow) {
  const EglContext context;
  try {
    const ShaderProgram broken("draw_caster.vert", "draw_depth.frag", "this is not GLSL\n");
    FAIL() << "compiled";
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("draw_caster.vert"), std::string::npos) << what;
    EXPECT_NE(what.find("2: this is not GLSL"), std::string::npos) << what;
  }
}

TEST(ShaderSources, HaveNoIncludesLeft) {
  for (const char* file : {"draw_surface.vert", "shade_diffuse.frag", "accumulate_glass.frag"}) {
    EXPECT_EQ(shaders::source(file).find("#include"), std::string_view::npos) << file;
    EXPECT_EQ(shaders::source(file).substr(0, 8), "#version") << file;
  }
  EXPECT_THROW(shaders::source("missing.frag"), std::out_of_range);
}

TEST(ShaderFeatures, SayWhatTheSceneLacks) {
  scene::Scene scene;
  add_object(scene, make_floor(0.0f, 1.0f), make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  ShaderFeatures features = find_features(scene);
  EXPECT_TRUE(features.real_opaque);
  EXPECT_FALSE(features.virtual_opaque || features.real_glass || features.virtual_glass ||
               features.textures);
  add_object(scene, make_floor(0.0f, 1.0f), make_glass(), scene::Role::Virtual);
  add_object(scene, make_floor(0.0f, 1.0f), make_mirror(), scene::Role::Virtual);
  features = find_features(scene);
  EXPECT_TRUE(features.virtual_glass && features.virtual_opaque);
  EXPECT_FALSE(features.real_glass);
  EXPECT_FALSE(features.vertex_colors);

  scene::Mesh colored = make_floor(0.0f, 1.0f);
  colored.colors.assign(colored.positions.size(), glm::vec4(0.5f));
  add_object(scene, colored, make_diffuse(glm::vec3(0.5f)), scene::Role::Real);
  features = find_features(scene);
  EXPECT_TRUE(features.vertex_colors);
  EXPECT_EQ(features.textures, 0u);
}

}  // namespace
}  // namespace amalgam::gl
