// Looks at the bytes of an Envelope while they arrive, before any of them is parsed or kept:
// parsing takes a hundred times the time and memory that a small field takes on the wire.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "protocol/amalgam.pb.h"

namespace amalgam::protocol {

class EnvelopeScan {
 public:
  enum class Verdict {
    Good,          // so far
    TooManyPoses,  // of a CameraFrame; what follows need not be looked at
    Bad,           // defect() says why
  };

  // The next bytes. After another verdict than Good every call returns the same one.
  Verdict take(std::span<const std::byte> bytes);
  // The Envelope is complete: Bad if something of it is missing.
  Verdict finish();

  const char* defect() const { return defect_; }
  std::uint64_t frame_id() const { return frame_id_; }  // of a CameraFrame, if it came so far

 private:
  enum class Expect { Tag, Varint, Length, Skip };

  void take_byte(unsigned byte);
  void on_tag();
  void on_length();
  void on_value_end();
  void bad(const char* why);
  bool is_image() const;

  Verdict verdict_ = Verdict::Good;
  const char* defect_ = "";
  Expect expect_ = Expect::Tag;
  std::uint64_t varint_ = 0;  // the one being read
  int varint_bytes_ = 0;
  std::uint32_t field_ = 0;
  std::uint32_t wire_type_ = 0;
  std::uint64_t skip_ = 0;               // bytes of a value that are not looked at
  bool skips_image_ = false;             // they are an image's, which has a limit of its own
  std::optional<std::uint64_t> inside_;  // bytes left of the body; nothing outside one
  int body_ = 0;                         // its field number; 0: none yet
  std::size_t small_bytes_ = 0;          // all but images
  int markers_ = 0;                      // of a CameraFrame, as poses or as corners
  std::uint64_t frame_id_ = 0;
};

}  // namespace amalgam::protocol
