#include "trace/embree_isa.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace amalgam::trace {
namespace {

// Any number of threads but 0 would limit those of the whole process for as long as the device
// lives (Embree 3.13 installs a tbb::global_control).
constexpr const char* kConfig = "threads=0,set_affinity=0";

std::string config_for(const std::string& isa) {
  return kConfig + (",isa=" + isa);
}

}  // namespace

std::string embree_device_config() {
  const char* isa = std::getenv(kIsaVariable);
  if (isa == nullptr || *isa == '\0') return kConfig;
  if (std::find(kIsas.begin(), kIsas.end(), std::string(isa)) == kIsas.end()) {
    std::string choices;
    for (const char* known : kIsas) choices += std::string(choices.empty() ? "" : ", ") + known;
    throw std::runtime_error(std::string(kIsaVariable) + " is '" + isa + "', not one of " +
                             choices);
  }
  return config_for(isa);
}

std::vector<std::string> usable_isas() {
  std::vector<std::string> usable;
  for (const char* isa : kIsas) {
    const RTCDevice device = rtcNewDevice(config_for(isa).c_str());
    if (device == nullptr) continue;
    rtcReleaseDevice(device);
    usable.emplace_back(isa);
  }
  return usable;
}

}  // namespace amalgam::trace
