#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <random>

#include "scene/gltf/loader.h"
#include "support/test_data.h"
#include "unit/scene/gltf_sample.h"

// Wrong files by the hundred: nothing crashes or hangs, and what the Khronos validator calls an
// error is refused unless it cannot change the picture.

namespace amalgam::scene {
namespace {

namespace fs = std::filesystem;

bool is_scene(const fs::path& path) {
  return path.extension() == ".gltf" || path.extension() == ".glb";
}

enum class Outcome { Accepted, AcceptedWithNotes, Refused };

Outcome load(const fs::path& path) {
  const auto start = std::chrono::steady_clock::now();
  Outcome outcome = Outcome::Refused;
  try {
    outcome = load_scene(path).notes.empty() ? Outcome::Accepted : Outcome::AcceptedWithNotes;
  } catch (const SceneError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(path.filename().string()), std::string::npos)
        << error.what();
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10)) << path;
  return outcome;
}

// numErrors of a validator's report, found without a JSON library.
std::optional<int> errors_of(const fs::path& report) {
  std::ifstream file(report);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::string key = "\"numErrors\":";
  const std::size_t at = text.find(key);
  if (at == std::string::npos) return std::nullopt;
  return std::stoi(text.substr(at + key.size()));
}

TEST(GltfRobustness, AgreesWithTheKhronosValidator) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  int wrong = 0, wrong_refused = 0, wrong_noted = 0, right = 0, right_accepted = 0;
  std::string missed, strict;
  for (const auto& entry :
       fs::recursive_directory_iterator(*data / "robustness" / "gltf_validator")) {
    if (!is_scene(entry.path())) continue;
    const auto errors = errors_of(entry.path().string() + ".report.json");
    if (!errors) continue;
    const Outcome outcome = load(entry.path());
    if (*errors > 0) {
      ++wrong;
      wrong_refused += outcome == Outcome::Refused;
      wrong_noted += outcome == Outcome::AcceptedWithNotes;
      if (outcome == Outcome::Accepted) missed.append(" ").append(entry.path().filename().string());
    } else {
      ++right;
      right_accepted += outcome != Outcome::Refused;
      if (outcome == Outcome::Refused) strict.append(" ").append(entry.path().filename().string());
    }
  }
  std::cout << "refused " << wrong_refused << " of " << wrong << " wrong files and noted "
            << wrong_noted << "; accepted without a word:" << missed << "\naccepted "
            << right_accepted << " of " << right << " right files; refused:" << strict << "\n";
  // Refused is what would make the picture wrong. What is left without a note: values of animations
  // and skins, which are not read.
  EXPECT_GE(wrong_refused, wrong * 45 / 100);
  EXPECT_GE(wrong_refused + wrong_noted, wrong * 97 / 100);
  // What is left: buffers without any data, a URL, minVersion 2.1, an unknown accessor type.
  EXPECT_GE(right_accepted, right * 84 / 100);
}

TEST(GltfRobustness, CrashReproducersAreReadOrRefused) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  for (const char* folder : {"robustness/gltf_tinygltf", "gltf", "meshes"}) {
    for (const auto& entry : fs::recursive_directory_iterator(*data / folder)) {
      if (is_scene(entry.path())) load(entry.path());
    }
  }
  EXPECT_EQ(load(*data / "robustness/gltf_tinygltf/tests/issue-416.gltf"), Outcome::Refused);
}

// Files that authors made to be drawn: all are.
TEST(GltfRobustness, FilesForViewersAreRead) {
  const auto data = tests::test_data();
  if (!data) GTEST_SKIP() << "test data not found";
  for (const auto& entry : fs::recursive_directory_iterator(*data / "gltf")) {
    if (!is_scene(entry.path())) continue;
    EXPECT_NE(load(entry.path()), Outcome::Refused) << entry.path();
  }
}

TEST(GltfRobustness, EveryTruncationIsRefused) {
  const std::string text = sample_gltf();
  for (std::size_t size = 0; size < text.size() - 1; size += 11) {
    EXPECT_NE(refusal_of(text.substr(0, size)), "accepted") << size;
  }
}

// Random edits of a right file: numbers, brackets, names. Every outcome but a crash is fine.
TEST(GltfRobustness, MutatedFilesAreReadOrRefused) {
  const std::string text = sample_gltf();
  const std::array<std::string, 14> pieces{
      "0",   "-1",   "1e308", "4294967295", "9007199254740993", "null", "[]", "{}", "\"", ",",
      "[0]", "5126", "0.5",   "true"};
  std::mt19937 random(7);
  const std::size_t json_end = text.find("\"uri\"");
  int accepted = 0;
  for (int i = 0; i < 1000; ++i) {
    std::string mutated = text;
    for (int edit = 0; edit < 1 + i % 3; ++edit) {
      const std::size_t at = random() % json_end;
      mutated.replace(at, random() % 4, pieces[random() % pieces.size()]);
    }
    accepted += refusal_of(mutated) == "accepted";
  }
  // Not all that is edited makes a difference.
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, 200);
}

}  // namespace
}  // namespace amalgam::scene
