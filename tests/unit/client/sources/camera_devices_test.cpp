#include "client/sources/camera_devices.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace amalgam::client {
namespace {

class CameraDevices : public testing::Test {
 protected:
  void add(const std::string& device, const std::string& name, const std::string& index) {
    std::filesystem::create_directories(folder_ / device);
    std::ofstream(folder_ / device / "name") << name << '\n';
    std::ofstream(folder_ / device / "index") << index << '\n';
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("camera_devices_" + std::to_string(getpid()));
};

TEST_F(CameraDevices, AreListedByNumberWithoutWhatIsNoPicture) {
  add("video10", "Second", "0");
  add("video2", "First: Webcam", "0");
  add("video3", "First: Webcam", "1");  // metadata
  add("v4l-subdev0", "Sensor", "0");
  const auto cameras = find_cameras(folder_);
  ASSERT_EQ(cameras.size(), 2u);
  EXPECT_EQ(cameras[0].number, 2);
  EXPECT_EQ(cameras[0].name, "First: Webcam");
  EXPECT_EQ(cameras[1].number, 10);
}

TEST_F(CameraDevices, AMachineWithoutAnyHasNoFolder) {
  EXPECT_TRUE(find_cameras(folder_).empty());
}

}  // namespace
}  // namespace amalgam::client
