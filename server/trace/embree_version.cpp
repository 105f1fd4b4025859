#include "trace/embree_version.h"

#include <embree3/rtcore.h>

#include <memory>
#include <type_traits>
#include <utility>

#include "trace/embree_isa.h"

namespace amalgam::trace {

std::string embree_version() {
  const std::unique_ptr<std::remove_pointer_t<RTCDevice>, decltype(&rtcReleaseDevice)> device(
      rtcNewDevice(embree_device_config().c_str()), &rtcReleaseDevice);
  if (!device) return "Embree, which cannot run on this processor";
  const auto property = [&](RTCDeviceProperty name) {
    return static_cast<int>(rtcGetDeviceProperty(device.get(), name));
  };
  const int version = property(RTC_DEVICE_PROPERTY_VERSION);  // 31305
  std::string text = "Embree " + std::to_string(version / 10000) + "." +
                     std::to_string(version / 100 % 100) + "." + std::to_string(version % 100);
  const char* separator = ", packets of ";
  for (const auto& [name, rays] : {std::pair{RTC_DEVICE_PROPERTY_NATIVE_RAY4_SUPPORTED, "4"},
                                   std::pair{RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED, "8"},
                                   std::pair{RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED, "16"}}) {
    if (property(name) == 0) continue;
    text += std::exchange(separator, " and ");
    text += rays;
  }
  return text;
}

}  // namespace amalgam::trace
