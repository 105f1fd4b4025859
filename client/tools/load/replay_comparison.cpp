#include "client/tools/load/replay_comparison.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/whole_file.h"

namespace amalgam::load {

std::vector<std::string> differences(const protocol::Fingerprint& recorded,
                                     const protocol::Fingerprint& now) {
  std::vector<std::string> texts;
  const auto compare = [&](const char* name, const std::string& before, const std::string& after) {
    const auto or_nothing = [](const std::string& text) { return text.empty() ? "nothing" : text; };
    if (before == after) return;
    texts.push_back(std::string(name) + ": " + or_nothing(after) + ", recorded with " +
                    or_nothing(before));
  };
  compare("build", recorded.build(), now.build());
  compare("scene", recorded.scene(), now.scene());
  compare("scene_hash", recorded.scene_hash(), now.scene_hash());
  compare("options", recorded.options(), now.options());
  compare("hardware", recorded.hardware(), now.hardware());
  return texts;
}

ReplayComparison::ReplayComparison(const RecordedSession& session, std::filesystem::path folder)
    : session_(session),
      folder_(std::move(folder)),
      recorded_(static_cast<std::uint64_t>(std::ranges::count_if(
          session.frames, [](const RecordedFrame& frame) { return frame.rendered.has_value(); }))) {
  if (!folder_.empty()) std::filesystem::create_directories(folder_);
  if (session.header.fingerprint().options().find("--target-fps") != std::string::npos) {
    remark("recorded with a target frame rate: times decide the quality, and so the bytes");
  }
  if (session.end == "cut") remark("the record breaks off: its server may have crashed");
}

void ReplayComparison::welcomed(const protocol::Welcome& welcome) {
  differences_ = differences(session_.header.fingerprint(), welcome.fingerprint());
}

const RecordedFrame* ReplayComparison::find(std::uint64_t number) {
  const auto frame = std::ranges::find(session_.frames, number, &RecordedFrame::number);
  const bool is_new = frame != session_.frames.end() && seen_.insert(number).second;
  if (is_new && !frame->rendered) ++only_now_;
  return is_new && frame->rendered ? &*frame : nullptr;
}

void ReplayComparison::answered(std::uint64_t number, const protocol::Composite& composite) {
  const RecordedFrame* const frame = find(number);
  if (frame == nullptr) return;
  const std::string* const before = frame->jpeg();
  const bool equal = before != nullptr && *before == composite.jpeg();
  count(*frame, equal);
  if (!equal) write(*frame, &composite.jpeg());
}

void ReplayComparison::refused(std::uint64_t number, const protocol::Error& error) {
  const RecordedFrame* const frame = find(number);
  if (frame == nullptr) return;
  const bool equal =
      frame->rendered->has_error() && frame->rendered->error().code() == error.code();
  count(*frame, equal);
  if (equal) return;
  remark("frame " + std::to_string(number) + ": " + protocol::Error::Code_Name(error.code()) +
         ": " + error.text());
  write(*frame, nullptr);
}

void ReplayComparison::count(const RecordedFrame& frame, bool equal) {
  ++(equal ? equal_ : different_);
  const bool is_first = first_different_ == nullptr || frame.number < first_different_->number;
  if (!equal && is_first) first_different_ = &frame;
}

void ReplayComparison::write(const RecordedFrame& frame, const std::string* now) const {
  if (folder_.empty()) return;
  const auto write_jpeg = [&](const char* which, const std::string* jpeg) {
    if (jpeg == nullptr) return;
    char name[64];
    std::snprintf(name, sizeof name, "frame-%06llu-%s.jpg",
                  static_cast<unsigned long long>(frame.number), which);
    common::write_whole_file(folder_ / name, *jpeg);
  };
  write_jpeg("recorded", frame.jpeg());
  write_jpeg("replayed", now);
}

bool ReplayComparison::is_good(bool all_again) const {
  const bool nothing_compared = recorded_ > 0 && equal_ == 0;
  return different_ == 0 && !nothing_compared && !(all_again && missing() > 0);
}

std::string ReplayComparison::to_json() const {
  nlohmann::ordered_json first = nullptr;
  if (first_different_ != nullptr) {
    first = {{"number", first_different_->number},
             {"frame_id", first_different_->message.frame_id()}};
  }
  const nlohmann::ordered_json json = {{"frames", recorded_},
                                       {"equal", equal_},
                                       {"different", different_},
                                       {"missing", missing()},
                                       {"only_now", only_now_},
                                       {"first_different", first},
                                       {"server_differs", differences_},
                                       {"record_ended", session_.end},
                                       {"remarks", remarks_}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace amalgam::load
