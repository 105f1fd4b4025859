#include "scene/gltf/doubtful_extras.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace amalgam::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A file of which something is ours, so that only what else it has is doubtful.
std::vector<std::string> doubts_of(const std::string& more) {
  const JsonValue root =
      parse_json(R"({"scenes": [{"extras": {"amalgam": {"world_marker": 40}}}], )" + more + "}");
  return doubtful_extras(JsonCursor(root));
}

std::vector<std::string> doubts_of_node(const std::string& extras) {
  return doubts_of(R"("nodes": [{"extras": )" + extras + "}]");
}

TEST(DoubtfulExtras, MisspeltMembersAreNamedWithWhatWasMeant) {
  for (const char* role : {"role", "Role", "rolle", "rol", "amalgam_role", "amalgam.role",
                           "AmalgamRole", "amalgam_rolle"}) {
    EXPECT_THAT(
        doubts_of_node(R"({")" + std::string(role) + R"(": "real"})"),
        ElementsAre(testing::AllOf(HasSubstr(role), HasSubstr(R"({"role": ...} at a node)"))))
        << role;
  }
  EXPECT_THAT(doubts_of_node(R"({"maker": 23})"), ElementsAre(HasSubstr(R"({"marker": ...})")));
  EXPECT_THAT(doubts_of_node(R"({"World Marker": 23})"),
              ElementsAre(HasSubstr(R"({"world_marker": ...} at a scene)")));
  EXPECT_THAT(doubts_of_node(R"({"marker_lenght": 0.05})"),
              ElementsAre(HasSubstr(R"({"marker_length": ...} at a scene)")));
}

TEST(DoubtfulExtras, OurOwnNameMayBeMisspeltToo) {
  for (const char* ours : {"Amalgam", "amalgm", "amalagam", "amalgam "}) {
    EXPECT_THAT(doubts_of_node(R"({")" + std::string(ours) + R"(": {"role": "real"}})"),
                ElementsAre(HasSubstr("is not read; ")))
        << ours;
  }
}

TEST(DoubtfulExtras, ForeignPropertiesAreNot) {
  EXPECT_THAT(doubts_of_node(R"({"hole": "real", "roll": 0.3, "controller": "x", "poles": 2,
                                 "makers": "us", "_RNA_UI": {}, "": 1, "lightmap": "a.png"})"),
              IsEmpty());
}

TEST(DoubtfulExtras, OursInTheWrongPlaceAre) {
  for (const char* place : {"meshes", "materials", "cameras"}) {
    EXPECT_THAT(doubts_of(R"(")" + std::string(place) +
                          R"(": [{"extras": {"amalgam": {"role": "real"}}}])"),
                ElementsAre(std::string(place) +
                            "[0].extras.amalgam: is not read here, only at nodes and scenes"));
  }
}

TEST(DoubtfulExtras, AFileWithoutOursIsTold) {
  const JsonValue root = parse_json(R"({"nodes": [{"extras": {"prop": 1}}]})");
  EXPECT_THAT(doubtful_extras(JsonCursor(root)), ElementsAre(HasSubstr("all of it is virtual")));
}

}  // namespace
}  // namespace amalgam::scene
