#include "faults/failing_driver.h"

#include <dlfcn.h>
#include <embree3/rtcore.h>
#include <epoxy/gl.h>

#include <atomic>
#include <type_traits>
#include <utility>

namespace amalgam::test {
namespace {

// The k-th of something fails, once.
class Countdown {
 public:
  void set(std::int64_t k) { left_ = k; }
  bool fails() {
    if (left_.load() < 0 || left_.fetch_sub(1) != 0) return false;
    ++failed_;
    return true;
  }
  std::uint64_t failed() const { return failed_; }

 private:
  std::atomic<std::int64_t> left_ = -1;
  std::atomic<std::uint64_t> failed_ = 0;
};

Countdown opengl, commits, allocations;
std::atomic<bool> out_of_memory = false;

GLenum (*real_get_error)() = nullptr;
GLenum get_error() {
  return out_of_memory.exchange(false) ? GL_OUT_OF_MEMORY : real_get_error();
}

template <auto* kFunction, typename Signature = std::remove_pointer_t<decltype(kFunction)>>
struct Watched;

template <auto* kFunction, typename... Arguments>
struct Watched<kFunction, void (*)(Arguments...)> {
  static inline void (*real)(Arguments...) = nullptr;
  static void call(Arguments... arguments) {
    if (opengl.fails()) {
      out_of_memory = true;
    } else {
      real(arguments...);
    }
  }
  static void watch() { real = std::exchange(*kFunction, call); }
};

template <auto*... kFunctions>
void watch_all() {
  (Watched<kFunctions>::watch(), ...);
}

bool may_allocate(void*, ssize_t bytes, bool) {
  return bytes <= 0 || !allocations.fails();
}

}  // namespace

void watch_opengl() {
  real_get_error = std::exchange(epoxy_glGetError, get_error);
  watch_all<&epoxy_glTextureStorage2D, &epoxy_glTextureStorage3D, &epoxy_glTextureSubImage2D,
            &epoxy_glNamedBufferStorage, &epoxy_glClearTexSubImage,
            &epoxy_glClearNamedFramebufferfv, &epoxy_glClearNamedFramebufferuiv,
            &epoxy_glDrawElements, &epoxy_glDrawArrays, &epoxy_glGetTextureImage,
            &epoxy_glGetTextureSubImage>();
}

void fail_opengl_call(std::int64_t k) {
  opengl.set(k);
}
void fail_embree_commit(std::int64_t k) {
  commits.set(k);
}
void fail_embree_allocation(std::int64_t k) {
  allocations.set(k);
}
std::uint64_t failed_opengl_calls() {
  return opengl.failed();
}
std::uint64_t failed_embree_commits() {
  return commits.failed();
}
std::uint64_t failed_embree_allocations() {
  return allocations.failed();
}

namespace {

std::atomic<RTCError> embree_error = RTC_ERROR_NONE;

template <typename Function>
Function* embrees_own(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

template <typename Handle>
void commit(const char* name, Handle handle) {
  if (commits.fails()) {
    embree_error = RTC_ERROR_OUT_OF_MEMORY;
  } else {
    embrees_own<void(Handle)>(name)(handle);
  }
}

}  // namespace
}  // namespace amalgam::test

// The program's own functions come before Embree's, which they call.
extern "C" {

RTCDevice rtcNewDevice(const char* config) {
  using namespace amalgam::test;
  const RTCDevice device = embrees_own<RTCDevice(const char*)>("rtcNewDevice")(config);
  if (device != nullptr) rtcSetDeviceMemoryMonitorFunction(device, may_allocate, nullptr);
  return device;
}

void rtcCommitGeometry(RTCGeometry geometry) {
  amalgam::test::commit("rtcCommitGeometry", geometry);
}

void rtcCommitScene(RTCScene scene) {
  amalgam::test::commit("rtcCommitScene", scene);
}

RTCError rtcGetDeviceError(RTCDevice device) {
  using namespace amalgam::test;
  const RTCError error = embree_error.exchange(RTC_ERROR_NONE);
  if (error != RTC_ERROR_NONE) return error;
  return embrees_own<RTCError(RTCDevice)>("rtcGetDeviceError")(device);
}
}
