// For tests of what must hold on every transport.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "support/net/test_server.h"

namespace amalgam::test {

// A suite derives from it, takes GetParam() for its TestServer, and ends with
// INSTANTIATE_TEST_SUITE_P(Over, Suite, kEachTransport, transport_name);
class EachTransport : public testing::TestWithParam<Over> {};

inline const auto kEachTransport = testing::Values(Over::Tcp, Over::WebSocket);

inline std::string transport_name(const testing::TestParamInfo<Over>& info) {
  return info.param == Over::Tcp ? "Tcp" : "WebSocket";
}

}  // namespace amalgam::test
