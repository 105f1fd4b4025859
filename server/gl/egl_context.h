// An OpenGL 4.5 core context without a window, and the one thread that may use it.
#pragma once

#include <string>
#include <thread>

namespace amalgam::gl {

class EglContext {
 public:
  // Makes the context current on the calling thread, which owns it from then on. Tries Mesa's
  // surfaceless platform, then each EGL device, then the default display. Throws std::runtime_error
  // that says what to do, and lists each attempt and its failure.
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  // Aborts with a message if called on another thread than the owner.
  void check_thread() const;

  // Where one thread has several contexts: this one is used from here on.
  void make_current() const;

  const std::string& platform() const { return platform_; }  // "surfaceless", "device 0", ...
  const std::string& vendor() const { return vendor_; }
  const std::string& renderer() const { return renderer_; }
  const std::string& version() const { return version_; }

 private:
  void* display_ = nullptr;  // EGLDisplay
  void* context_ = nullptr;  // EGLContext
  std::thread::id owner_;
  std::string platform_, vendor_, renderer_, version_;
};

}  // namespace amalgam::gl
