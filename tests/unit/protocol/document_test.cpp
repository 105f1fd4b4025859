// Reads the hex examples of PROTOCOL.md, so that the document cannot drift away from the code.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "protocol/framing.h"
#include "protocol/limits.h"

namespace amalgam::protocol {
namespace {

const std::map<std::string, Envelope::BodyCase> kKinds{{"Hello", Envelope::kHello},
                                                       {"CameraFrame", Envelope::kCameraFrame},
                                                       {"Environment", Envelope::kEnvironment},
                                                       {"Ping", Envelope::kPing},
                                                       {"Pong", Envelope::kPong},
                                                       {"Goodbye", Envelope::kGoodbye},
                                                       {"Welcome", Envelope::kWelcome},
                                                       {"Composite", Envelope::kComposite},
                                                       {"Busy", Envelope::kBusy},
                                                       {"Error", Envelope::kError},
                                                       {"Draining", Envelope::kDraining}};

std::string document() {
  std::ifstream file(AMALGAM_SOURCE_DIR "/protocol/PROTOCOL.md");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// The fenced blocks "```hex Kind" with their bytes.
std::multimap<std::string, std::string> hex_examples() {
  std::multimap<std::string, std::string> examples;
  std::istringstream lines(document());
  std::string line;
  while (std::getline(lines, line)) {
    const std::string fence = "```hex ";
    if (!line.starts_with(fence)) continue;
    const std::string kind = line.substr(fence.size());
    std::string bytes;
    while (std::getline(lines, line) && line != "```") {
      std::istringstream pairs(line);
      std::string pair;
      while (pairs >> pair) bytes.push_back(static_cast<char>(std::stoi(pair, nullptr, 16)));
    }
    examples.emplace(kind, bytes);
  }
  return examples;
}

Envelope decode(const std::string& bytes) {
  Decoder decoder(limits_of_client());
  auto input = std::as_bytes(std::span(bytes));
  Decoder::Result result = decoder.next(input);
  EXPECT_TRUE(input.empty()) << "bytes behind the message";
  EXPECT_TRUE(std::holds_alternative<Envelope>(result));
  return std::holds_alternative<Envelope>(result) ? std::get<Envelope>(result) : Envelope();
}

TEST(ProtocolDocument, EveryMessageHasAnExampleThatDecodesToItAndBack) {
  std::set<std::string> seen;
  for (const auto& [kind, bytes] : hex_examples()) {
    SCOPED_TRACE(kind);
    ASSERT_TRUE(kKinds.contains(kind));
    const Envelope envelope = decode(bytes);
    EXPECT_EQ(envelope.body_case(), kKinds.at(kind));
    EXPECT_EQ(encode(envelope), bytes);
    seen.insert(kind);
  }
  EXPECT_EQ(seen.size(), kKinds.size());
}

TEST(ProtocolDocument, ExamplesSayWhatTheTextSays) {
  const auto examples = hex_examples();
  ASSERT_TRUE(examples.contains("Hello") && examples.contains("CameraFrame"));
  const Hello hello = decode(examples.find("Hello")->second).hello();
  EXPECT_EQ(hello.version(), kProtocolVersion);
  EXPECT_EQ(hello.camera().width(), 640u);
  EXPECT_EQ(hello.camera().fx(), 600.0);
  const CameraFrame frame = decode(examples.find("CameraFrame")->second).camera_frame();
  ASSERT_EQ(frame.poses_size(), 1);
  EXPECT_EQ(frame.poses(0).marker(), 40);
  EXPECT_EQ(frame.poses(0).rotation().x(), 1.0);
  EXPECT_EQ(frame.poses(0).translation().z(), 0.5);
}

TEST(ProtocolDocument, EnvironmentsAreEquirectangularAndFisheyeForAllOrForOne) {
  const auto examples = hex_examples();
  ASSERT_EQ(examples.count("Environment"), 3u);
  const auto first = examples.lower_bound("Environment");
  EXPECT_FALSE(decode(first->second).environment().has_fisheye());
  EXPECT_FALSE(decode(first->second).environment().own());
  const Environment own = decode(std::next(first)->second).environment();
  EXPECT_TRUE(own.own() && !own.has_fisheye());
  const Environment environment = decode(std::next(first, 2)->second).environment();
  EXPECT_EQ(environment.image(), "\xff\xd8\xff\xd9");
  ASSERT_TRUE(environment.has_fisheye());
  EXPECT_EQ(environment.fisheye().width(), 1000u);
  EXPECT_EQ(environment.fisheye().fx(), 312.5);
  EXPECT_EQ(environment.fisheye().max_angle(), 1.6);
  EXPECT_EQ(environment.fisheye().world_from_fisheye().y(), 0.6);
  EXPECT_EQ(environment.fisheye().world_from_fisheye().z(), 0.8);
}

TEST(ProtocolDocument, NamesEveryErrorCode) {
  const std::string text = document();
  for (int code = Error::Code_MIN + 1; code <= Error::Code_MAX; ++code) {
    const std::string name = Error::Code_Name(static_cast<Error::Code>(code));
    EXPECT_NE(text.find("| " + std::to_string(code) + " | `" + name + "` |"), std::string::npos)
        << name;
  }
}

}  // namespace
}  // namespace amalgam::protocol
