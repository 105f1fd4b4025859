#include <cstdio>
#include <stdexcept>
#include <system_error>

#include "client/sinks/frame_sink.h"
#include "common/whole_file.h"

namespace amalgam::client {
namespace {

class FolderSink : public FrameSink {
 public:
  explicit FolderSink(const std::filesystem::path& folder) : folder_(folder) {
    std::error_code why, ignored;
    std::filesystem::create_directories(folder, why);
    if (!std::filesystem::is_directory(folder, ignored)) {
      throw std::runtime_error("--output: " + folder.string() + " cannot be made (" +
                               why.message() + ")");
    }
  }

  void show(std::uint64_t frame_id, std::span<const unsigned char> jpeg) override {
    char name[40];
    std::snprintf(name, sizeof name, "frame-%06llu.jpg", static_cast<unsigned long long>(frame_id));
    const std::filesystem::path file = folder_ / name;
    common::write_whole_file(file, {reinterpret_cast<const char*>(jpeg.data()), jpeg.size()});
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace

std::unique_ptr<FrameSink> make_folder_sink(const std::filesystem::path& folder) {
  return std::make_unique<FolderSink>(folder);
}

}  // namespace amalgam::client
