#include "common/one_line.h"

#include <gtest/gtest.h>

namespace amalgam::common {
namespace {

TEST(OneLine, ControlCharactersBecomeSpaces) {
  EXPECT_EQ(one_line("a\r\nb\tc\x1b[31m\x7f"), "a  b c [31m ");
  EXPECT_EQ(one_line(std::string_view("a\0b", 3)), "a b");
  EXPECT_EQ(one_line("text\r\n\n"), "text");
  EXPECT_EQ(one_line("\n"), "");
  EXPECT_EQ(one_line(""), "");
}

// U+009B begins a command to a terminal, as ESC [ does.
TEST(OneLine, TheSecondBlockOfControlsToo) {
  EXPECT_EQ(one_line("a\xC2\x9B"
                     "31m"),
            "a  31m");
  EXPECT_EQ(one_line("a\xC2"), "a\xC2");
}

TEST(OneLine, OtherTextStaysAsItIs) {
  const std::string text = "caf\xC3\xA9 \xC2\xA0 \xE2\x82\xAC \xFF";
  EXPECT_EQ(one_line(text), text);
}

}  // namespace
}  // namespace amalgam::common
