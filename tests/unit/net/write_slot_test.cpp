#include "net/write_slot.h"

#include <gtest/gtest.h>

#include "protocol/framing.h"

namespace amalgam::net {
namespace {

using protocol::Envelope;

Envelope ping(std::uint64_t nonce) {
  Envelope envelope;
  envelope.mutable_ping()->set_nonce(nonce);
  return envelope;
}

Answer composite(std::uint64_t frame_id) {
  Answer answer;
  answer.frame.frame_id = frame_id;
  return answer;
}

Envelope decode(const std::optional<std::string>& bytes) {
  EXPECT_TRUE(bytes);
  if (!bytes) return {};
  protocol::Decoder decoder(protocol::limits_of_client());
  auto input = std::as_bytes(std::span(*bytes));
  return std::get<Envelope>(decoder.next(input));
}

TEST(WriteSlot, OneWriteIsInFlight) {
  WriteSlot slot(4);
  EXPECT_FALSE(slot.begin_write(0));
  slot.put_control(ping(1));
  slot.put_control(ping(2));
  EXPECT_EQ(decode(slot.begin_write(0)).ping().nonce(), 1u);
  EXPECT_FALSE(slot.begin_write(0));
  slot.end_write();
  EXPECT_EQ(decode(slot.begin_write(0)).ping().nonce(), 2u);
  EXPECT_FALSE(slot.empty());
  slot.end_write();
  EXPECT_TRUE(slot.empty());
}

TEST(WriteSlot, TheNewestCompositeWinsAndTheOneBeingWrittenStays) {
  WriteSlot slot(4);
  EXPECT_FALSE(slot.put_answer(composite(1)));
  const auto first = slot.begin_write(0);
  EXPECT_TRUE(slot.writing_answer());
  EXPECT_FALSE(slot.put_answer(composite(2)));
  EXPECT_TRUE(slot.put_answer(composite(3)));
  EXPECT_EQ(decode(first).composite().frame_id(), 1u);
  slot.end_write();
  const Envelope second = decode(slot.begin_write(1));
  EXPECT_EQ(second.composite().frame_id(), 3u);
  EXPECT_EQ(second.composite().skipped(), 1u);  // known only when it is written
}

TEST(WriteSlot, ControlGoesFirstAndIsBounded) {
  WriteSlot slot(2);
  slot.put_answer(composite(1));
  EXPECT_TRUE(slot.put_control(ping(1)));
  EXPECT_TRUE(slot.put_control(ping(2)));
  EXPECT_FALSE(slot.put_control(ping(3)));
  EXPECT_TRUE(decode(slot.begin_write(0)).has_ping());
  EXPECT_FALSE(slot.writing_answer());
  slot.end_write();
  slot.drop_control();
  EXPECT_TRUE(slot.drop_answer());
  EXPECT_FALSE(slot.drop_answer());
  EXPECT_TRUE(slot.empty());
}

}  // namespace
}  // namespace amalgam::net
