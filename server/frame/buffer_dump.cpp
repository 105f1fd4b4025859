#include "frame/buffer_dump.h"

#include "codec/exr.h"

namespace amalgam::frame {

void write_buffers(const FrameBuffers& buffers, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const auto& [name, buffer] : buffers) {
    std::visit([&](const auto& image) { codec::write_exr(folder / (name + ".exr"), image); },
               buffer);
  }
}

}  // namespace amalgam::frame
