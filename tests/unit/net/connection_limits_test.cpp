#include "net/connection_limits.h"

#include <gtest/gtest.h>

#include <vector>

namespace amalgam::net {
namespace {

using Ticket = ConnectionLimits::Ticket;
using Refusal = ConnectionLimits::Refusal;

TEST(ConnectionLimits, EachCapHoldsAndIsGivenBack) {
  ConnectionLimits limits({.total = 4, .unauthenticated = 3, .per_address = 2, .admin = 1});
  std::vector<Ticket> tickets;
  const auto admit = [&](const std::string& address) -> std::optional<Refusal> {
    auto admitted = limits.admit(address);
    if (const auto* refusal = std::get_if<Refusal>(&admitted)) return *refusal;
    tickets.push_back(std::get<Ticket>(std::move(admitted)));
    return std::nullopt;
  };
  EXPECT_FALSE(admit("a"));
  EXPECT_FALSE(admit("a"));
  EXPECT_EQ(admit("a"), Refusal::PerAddress);
  EXPECT_FALSE(admit("b"));
  EXPECT_EQ(admit("c"), Refusal::Unauthenticated);
  tickets[0].authenticated();
  tickets[0].authenticated();  // counts once
  EXPECT_FALSE(admit("c"));
  EXPECT_TRUE(limits.full());
  EXPECT_EQ(admit("d"), Refusal::Total);
  tickets.clear();
  EXPECT_EQ(limits.total(), 0u);
  EXPECT_FALSE(admit("a"));
  EXPECT_FALSE(admit("a"));
  EXPECT_FALSE(admit("b"));
}

}  // namespace
}  // namespace amalgam::net
