// The project's folders include only what rules.txt lets them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "layers/layer_rules.h"

namespace amalgam::layers {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

const std::filesystem::path kProject = AMALGAM_SOURCE_DIR;

Rules project_rules() {
  return parse_rules(read(kProject / "tests/layers/rules.txt"));
}

std::vector<SourceFile> project_files() {
  std::vector<SourceFile> files;
  for (const char* folder : {"protocol", "tracking", "sheet", "server", "client", "shaders"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kProject / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      files.push_back(
          {std::filesystem::relative(entry.path(), kProject).string(), read(entry.path())});
    }
  }
  return files;
}

TEST(Layers, AreKept) {
  EXPECT_THAT(find_violations(project_rules(), project_files()), IsEmpty());
}

TEST(Layers, HaveNoCircle) {
  EXPECT_THAT(find_circles(project_rules()), IsEmpty());
}

// A new folder needs a rule, or nobody would watch it.
TEST(Layers, EveryFolderHasARule) {
  const Rules rules = project_rules();
  for (const SourceFile& file : project_files()) {
    const std::string room = file.path.substr(0, file.path.rfind('/'));
    EXPECT_TRUE(rules.contains(room) || room == "shaders") << room;
  }
}

TEST(Layers, AForbiddenIncludeIsNamed) {
  const Rules rules = parse_rules("a: b\nb:\nc: b b/only.h\n");
  const std::vector<SourceFile> files{{"a/x.cpp", "#include <b>\n#include \"b/y.h\"\n"},
                                      {"b/y.h", "// why\n  #  include \"a/z.h\"\n"},
                                      {"a/z.h", ""}};
  EXPECT_THAT(find_violations(rules, files), ElementsAre("b/y.h:2: b may not include a (a/z.h)"));
}

TEST(Layers, ASingleHeaderMayBeAllowed) {
  const Rules rules = parse_rules("c: b/only.h\n");
  const std::vector<SourceFile> files{
      {"c/x.cpp", "#include \"b/only.h\"\n#include \"b/other.h\"\n#include \"b/none.h\"\n"},
      {"b/only.h", ""},
      {"b/other.h", ""}};
  EXPECT_THAT(
      find_violations(rules, files),
      ElementsAre("c/x.cpp:2: c may not include b (b/other.h)", "c/x.cpp:3: there is no b/none.h"));
}

TEST(Layers, CirclesAreNamed) {
  EXPECT_THAT(find_circles(parse_rules("a: b\nb: c\n  c/d.h\nc: a\n")),
              ElementsAre("a -> b -> c -> a"));
  EXPECT_THROW(parse_rules("a:\na: b\n"), std::invalid_argument);
  EXPECT_THROW(parse_rules("a b\n"), std::invalid_argument);
}

}  // namespace
}  // namespace amalgam::layers
