#include "net/token.h"

#include <gtest/gtest.h>

#include <string>

namespace amalgam::net {
namespace {

TEST(Token, EqualOnlyIfEveryByteIs) {
  EXPECT_TRUE(tokens_equal("opensesame", "opensesame"));
  EXPECT_FALSE(tokens_equal("opensesamf", "opensesame"));
  EXPECT_FALSE(tokens_equal("opensesam", "opensesame"));
  EXPECT_FALSE(tokens_equal("opensesame ", "opensesame"));
  EXPECT_FALSE(tokens_equal("", "opensesame"));
  EXPECT_FALSE(tokens_equal(std::string("a\0b", 3), std::string("a\0c", 3)));
}

}  // namespace
}  // namespace amalgam::net
