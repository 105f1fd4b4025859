// The yes-or-no questions that a pixel's rays answered on their way, as one number: what is met,
// from which side, what is cut off. Colors change smoothly between pixels that answer all of
// them alike; where a tiny nudge changes an answer, the pixel grazes an edge.
#pragma once

#include <cstdint>

namespace amalgam::reference {

class Decisions {
 public:
  // FNV-1a, a word at a time.
  void note(std::uint64_t answer) { signature_ = (signature_ ^ answer) * 0x100000001b3ULL; }

  // For answers that come in no particular order.
  void note_unordered(std::uint64_t answer) {
    Decisions one;
    one.note(answer + 1);
    one.note(answer);
    unordered_ += one.signature_;
  }

  // The answer depends on more digits than float has.
  void note_unsure() { unsure_ = true; }
  bool is_unsure() const { return unsure_; }

  std::uint64_t signature() const { return signature_ + unordered_; }

 private:
  std::uint64_t signature_ = 0xcbf29ce484222325ULL;
  std::uint64_t unordered_ = 0;
  bool unsure_ = false;
};

}  // namespace amalgam::reference
