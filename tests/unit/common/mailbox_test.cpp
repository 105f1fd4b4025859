#include "common/mailbox.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

namespace amalgam::common {
namespace {

TEST(Mailbox, NewestWinsAndTheLoserIsHandedBack) {
  Mailbox<int> mailbox;
  EXPECT_FALSE(mailbox.take());
  EXPECT_FALSE(mailbox.put(1));
  EXPECT_EQ(mailbox.put(2), 1);
  EXPECT_EQ(mailbox.take(), 2);
  EXPECT_FALSE(mailbox.take());
}

TEST(Mailbox, HoldsWhatCannotBeCopied) {
  Mailbox<std::unique_ptr<int>> mailbox;
  mailbox.put(std::make_unique<int>(5));
  EXPECT_EQ(**mailbox.take(), 5);
}

TEST(Mailbox, EveryMessageIsTakenOrHandedBack) {
  constexpr int kMessages = 20000;
  Mailbox<int> mailbox;
  int replaced = 0, taken = 0, last = -1;
  bool in_order = true;
  std::thread writer([&] {
    for (int i = 0; i < kMessages; ++i) replaced += mailbox.put(i).has_value() ? 1 : 0;
  });
  const auto take = [&] {
    if (const auto message = mailbox.take()) {
      in_order = in_order && *message > last;
      last = *message;
      ++taken;
    }
  };
  for (int i = 0; i < kMessages; ++i) take();
  writer.join();
  take();
  EXPECT_EQ(taken + replaced, kMessages);
  EXPECT_TRUE(in_order);
  EXPECT_EQ(last, kMessages - 1);
}

}  // namespace
}  // namespace amalgam::common
