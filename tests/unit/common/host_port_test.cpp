#include "common/host_port.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace amalgam::common {
namespace {

TEST(HostPort, ReadsAndWritesBothFamilies) {
  EXPECT_EQ(parse_host_port("127.0.0.1:7447"), (HostPort{"127.0.0.1", 7447}));
  EXPECT_EQ(parse_host_port("0.0.0.0:0"), (HostPort{"0.0.0.0", 0}));
  EXPECT_EQ(parse_host_port("[::1]:65535"), (HostPort{"::1", 65535}));
  EXPECT_EQ(to_string(HostPort{"::1", 5}), "[::1]:5");
  EXPECT_EQ(to_string(HostPort{"127.0.0.1", 5}), "127.0.0.1:5");
}

TEST(HostPort, RefusesAnythingElse) {
  for (const char* text : {"", ":", "127.0.0.1", "127.0.0.1:", ":7447", "a:65536", "a:-1", "a:1x",
                           "::1:7447", "[]:1"}) {
    EXPECT_THROW(parse_host_port(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace amalgam::common
