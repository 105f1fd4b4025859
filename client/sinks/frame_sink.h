// A destination of composites: a window, a film or a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace amalgam::client {

class FrameSink {
 public:
  virtual ~FrameSink() = default;
  // A composite's JPEG bytes as they were received. Throws std::runtime_error if it cannot be
  // shown.
  virtual void show(std::uint64_t frame_id, std::span<const unsigned char> jpeg) = 0;
  // True if the user wants to stop. Called often, from the viewer's thread.
  virtual bool wants_to_stop() { return false; }
};

// A window; q or Escape stops. Throws if there is no display.
std::unique_ptr<FrameSink> make_display_sink();

// A film (.mp4) of this many frames a second.
std::unique_ptr<FrameSink> make_record_sink(const std::filesystem::path& file, double rate);

// A file frame-000001.jpg for each composite, named by frame id. Creates the folder.
std::unique_ptr<FrameSink> make_folder_sink(const std::filesystem::path& folder);

}  // namespace amalgam::client
