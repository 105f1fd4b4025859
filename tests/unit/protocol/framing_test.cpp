#include "protocol/framing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/limits.h"

namespace amalgam::protocol {
namespace {

std::span<const std::byte> as_bytes(const std::string& text) {
  return std::as_bytes(std::span(text));
}

Envelope ping(std::uint64_t nonce) {
  Envelope envelope;
  envelope.mutable_ping()->set_nonce(nonce);
  return envelope;
}

Envelope frame_of(std::size_t jpeg_bytes) {
  Envelope envelope;
  envelope.mutable_camera_frame()->set_jpeg(std::string(jpeg_bytes, 'j'));
  return envelope;
}

std::string length_prefix(std::uint32_t length) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>((length >> (8 * i)) & 0xff));
  return bytes;
}

std::vector<Envelope> decode_all(Decoder& decoder, std::span<const std::byte> input) {
  std::vector<Envelope> envelopes;
  for (;;) {
    Decoder::Result result = decoder.next(input);
    if (!std::holds_alternative<Envelope>(result)) return envelopes;
    envelopes.push_back(std::get<Envelope>(std::move(result)));
  }
}

bool is_failure(Decoder& decoder, const std::string& bytes) {
  auto input = as_bytes(bytes);
  return std::holds_alternative<Decoder::Failure>(decoder.next(input));
}

TEST(Framing, LengthIsLittleEndianAndCountsTheEnvelopeOnly) {
  const std::string bytes = encode(frame_of(300));
  ASSERT_GE(bytes.size(), 304u);
  EXPECT_EQ(static_cast<unsigned char>(bytes[0]) + 256u * static_cast<unsigned char>(bytes[1]),
            bytes.size() - 4);
  EXPECT_EQ(bytes[2], 0);
  EXPECT_EQ(bytes[3], 0);
}

TEST(Framing, OneByteAtATimeAndAllCoalescedGiveTheSame) {
  std::string stream;
  for (std::uint64_t i = 0; i < 5; ++i) stream += encode(ping(i)) + encode(frame_of(1000 * i));
  Decoder coalesced(limits_of_server());
  const std::vector<Envelope> expected = decode_all(coalesced, as_bytes(stream));
  ASSERT_EQ(expected.size(), 10u);

  Decoder bytewise(limits_of_server());
  std::vector<Envelope> actual;
  for (const std::byte& byte : as_bytes(stream)) {
    for (Envelope& envelope : decode_all(bytewise, std::span(&byte, 1))) {
      actual.push_back(std::move(envelope));
    }
  }
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_EQ(encode(actual[i]), encode(expected[i]));
}

// Protobuf would merge what is left of an earlier message with the next: poses would add up, and
// what is 0 would keep its last value.
TEST(Framing, NothingOfAMessageIsLeftInTheNext) {
  Envelope full = frame_of(10);
  full.mutable_camera_frame()->set_frame_id(7);
  full.mutable_camera_frame()->add_poses()->set_marker(40);
  const std::vector<Envelope> sent{full, full, frame_of(0), ping(3), ping(0)};
  std::string stream;
  for (const Envelope& envelope : sent) stream += encode(envelope);
  Decoder decoder(limits_of_server());
  const std::vector<Envelope> received = decode_all(decoder, as_bytes(stream));
  ASSERT_EQ(received.size(), sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i)
    EXPECT_EQ(encode(received[i]), encode(sent[i])) << i;
}

TEST(Framing, TellsHowMuchOfAMessageIsHere) {
  const std::string bytes = encode(ping(300));
  Decoder decoder(limits_of_server());
  EXPECT_EQ(decoder.bytes_of_unfinished(), 0u);
  for (std::size_t i = 1; i < bytes.size(); ++i) {
    auto input = as_bytes(bytes).subspan(i - 1, 1);
    EXPECT_TRUE(std::holds_alternative<Decoder::NeedMore>(decoder.next(input)));
    EXPECT_EQ(decoder.bytes_of_unfinished(), i);
  }
  auto input = as_bytes(bytes).last(1);
  EXPECT_TRUE(std::holds_alternative<Envelope>(decoder.next(input)));
  EXPECT_EQ(decoder.bytes_of_unfinished(), 0u);
}

TEST(Framing, BadLengthsFailWithTheFourthByte) {
  const std::uint32_t limit = static_cast<std::uint32_t>(kMaxCameraFrameBytes);
  for (const std::uint32_t length : {0u, limit + 1, 0x7fffffffu, 0x80000000u, 0xffffffffu}) {
    Decoder decoder(limits_of_server());
    EXPECT_TRUE(is_failure(decoder, length_prefix(length))) << length;
    // And every call from then on: nothing behind it can be trusted.
    EXPECT_TRUE(is_failure(decoder, encode(ping(1)))) << length;
  }
}

TEST(Framing, LargestMessagesAreAcceptedAndOneByteMoreIsNot) {
  const std::size_t overhead =
      encode(frame_of(kMaxCameraFrameBytes / 2)).size() - kLengthBytes - kMaxCameraFrameBytes / 2;
  const std::string largest = encode(frame_of(kMaxCameraFrameBytes - overhead));
  ASSERT_EQ(largest.size(), kLengthBytes + kMaxCameraFrameBytes);
  Decoder decoder(limits_of_server());
  EXPECT_EQ(decode_all(decoder, as_bytes(largest)).size(), 1u);
  EXPECT_TRUE(is_failure(decoder, encode(frame_of(kMaxCameraFrameBytes - overhead + 1))));
}

TEST(Framing, LargestControlMessagesAreAcceptedAndOneByteMoreIsNot) {
  const auto hello = [](std::size_t token_bytes) {
    Envelope envelope;
    envelope.mutable_hello()->set_token(std::string(token_bytes, 't'));
    return encode(envelope);
  };
  const std::size_t overhead = hello(kMaxControlBytes / 2).size() - kMaxControlBytes / 2;
  const std::string largest = hello(kLengthBytes + kMaxControlBytes - overhead);
  ASSERT_EQ(largest.size(), kLengthBytes + kMaxControlBytes);
  Decoder decoder(limits_of_server());
  EXPECT_EQ(decode_all(decoder, as_bytes(largest)).size(), 1u);
  EXPECT_TRUE(is_failure(decoder, hello(kLengthBytes + kMaxControlBytes - overhead + 1)));
}

TEST(Framing, ControlMessagesAreJudgedByTheirFirstByte) {
  Envelope large;
  large.mutable_hello()->set_token(std::string(kMaxControlBytes, 't'));
  const std::string bytes = encode(large);
  Decoder decoder(limits_of_server());
  EXPECT_TRUE(is_failure(decoder, bytes.substr(0, kLengthBytes + 1)));
}

TEST(Framing, AnImageTagInFrontHidesNoLargeControlMessage) {
  // Protobuf takes the last body that it finds.
  Envelope large;
  large.mutable_hello()->set_token(std::string(kMaxControlBytes, 't'));
  const std::string body = frame_of(1).SerializeAsString() + large.SerializeAsString();
  Decoder decoder(limits_of_server());
  EXPECT_TRUE(is_failure(decoder, length_prefix(static_cast<std::uint32_t>(body.size())) + body));
}

TEST(Framing, BeforeTheHelloEverythingIsSmall) {
  Decoder decoder(limits_before_hello());
  EXPECT_TRUE(is_failure(decoder, length_prefix(kMaxBeforeHelloBytes + 1)));
}

TEST(Framing, NewLimitsHoldForTheNextMessage) {
  Decoder decoder(limits_before_hello());
  EXPECT_EQ(decode_all(decoder, as_bytes(encode(ping(1)))).size(), 1u);
  decoder.set_limits(limits_of_server());
  EXPECT_EQ(decode_all(decoder, as_bytes(encode(frame_of(10000)))).size(), 1u);
}

TEST(Framing, BytesThatAreNoEnvelopeFail) {
  for (const std::string& body : {std::string("\xff\xff\xff"), std::string("\x0a\x05"),
                                  std::string("\x07"), std::string(1, '\0')}) {
    Decoder decoder(limits_of_server());
    EXPECT_TRUE(is_failure(decoder, length_prefix(static_cast<std::uint32_t>(body.size())) + body));
  }
}

TEST(Framing, UnknownBodiesAreEnvelopesWithoutABody) {
  const std::string body = "\x7a\x01x";  // field 15
  const std::string bytes = length_prefix(3) + body;
  Decoder decoder(limits_of_server());
  const std::vector<Envelope> envelopes = decode_all(decoder, as_bytes(bytes));
  ASSERT_EQ(envelopes.size(), 1u);
  EXPECT_EQ(envelopes[0].body_case(), Envelope::BODY_NOT_SET);
}

// --- messages of a transport that marks their ends ---

Decoder::Result next_part(Decoder& decoder, const std::string& bytes, const Decoder::Part& part) {
  auto input = as_bytes(bytes);
  return decoder.next_part(input, part);
}

TEST(Framing, PartsOfAMessageMakeTheSameEnvelopeAndCountTheSame) {
  Decoder decoder(limits_of_server());
  const std::string body = frame_of(1000).SerializeAsString();
  for (int message = 0; message < 2; ++message) {
    for (std::size_t i = 0; i < body.size(); i += 100) {
      const std::string piece = body.substr(i, 100);
      const bool last = i + 100 >= body.size();
      const auto result = next_part(decoder, piece, {.at_least_left = 0, .last = last});
      ASSERT_EQ(std::holds_alternative<Envelope>(result), last);
      EXPECT_EQ(decoder.bytes_of_unfinished(), last ? 0 : kLengthBytes + i + piece.size());
      if (last) {
        EXPECT_EQ(std::get<Envelope>(result).SerializeAsString(), body);
      }
    }
  }
}

// A frame that says how long it is, is refused with its first byte.
TEST(Framing, WhatFollowsAPartCounts) {
  const std::string hello("\x0a"), frame("\x12");
  struct Row {
    SizeLimits limits;
    std::string begin;
    std::size_t most;
  };
  for (const Row& row : {Row{limits_before_hello(), hello, kMaxBeforeHelloBytes},
                         Row{limits_of_server(), hello, kMaxControlBytes},
                         Row{limits_of_server(), frame, kMaxCameraFrameBytes}}) {
    Decoder fits(row.limits), exceeds(row.limits), overflows(row.limits);
    EXPECT_TRUE(std::holds_alternative<Decoder::NeedMore>(
        next_part(fits, row.begin, {.at_least_left = row.most - 1, .last = false})));
    EXPECT_TRUE(std::holds_alternative<Decoder::Failure>(
        next_part(exceeds, row.begin, {.at_least_left = row.most, .last = false})));
    EXPECT_TRUE(std::holds_alternative<Decoder::Failure>(
        next_part(overflows, row.begin, {.at_least_left = SIZE_MAX, .last = false})));
  }
}

// Frames that each are short, of a message that never says how long it will be.
TEST(Framing, PartsAreRefusedWhenTheyExceedTheLimitOfTheirKind) {
  Decoder decoder(limits_of_server());
  std::string piece = "\x0a" + std::string(999, '\x80');
  std::size_t taken = 0;
  while (std::holds_alternative<Decoder::NeedMore>(next_part(decoder, piece, {}))) {
    taken += piece.size();
    ASSERT_LE(taken, kMaxControlBytes);
    piece = std::string(1000, '\0');
  }
}

TEST(Framing, AMessageOfNothingIsNone) {
  Decoder decoder(limits_of_server());
  EXPECT_TRUE(std::holds_alternative<Decoder::NeedMore>(next_part(decoder, "", {})));
  EXPECT_EQ(decoder.bytes_of_unfinished(), 0u);
  EXPECT_TRUE(std::holds_alternative<Decoder::Failure>(
      next_part(decoder, "", {.at_least_left = 0, .last = true})));
}

}  // namespace
}  // namespace amalgam::protocol
