#include "gl/egl_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <map>
#include <stdexcept>
#include <vector>

#include "common/log.h"
#include "gl/gl_error.h"

namespace amalgam::gl {
namespace {

std::string egl_error() {
  static const std::map<EGLint, const char*> kNames = {
      {EGL_SUCCESS, "no error given"},          {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
      {EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},       {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
      {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"}, {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
      {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT"},     {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},
      {EGL_BAD_MATCH, "EGL_BAD_MATCH"},         {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"}};
  const EGLint error = eglGetError();
  const auto name = kNames.find(error);
  return name != kNames.end() ? name->second : "EGL error " + std::to_string(error);
}

struct Candidate {
  std::string platform;
  EGLDisplay display = EGL_NO_DISPLAY;
};

// In the order in which they are tried. Adds unavailable ones to `failures`.
std::vector<Candidate> list_displays(std::vector<std::string>& failures) {
  std::vector<Candidate> candidates;
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    candidates.push_back({"surfaceless", eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA,
                                                                  EGL_DEFAULT_DISPLAY, nullptr)});
  } else {
    failures.emplace_back("surfaceless: no EGL_MESA_platform_surfaceless");
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) ==
        EGL_FALSE)
      count = 0;
    if (count == 0) failures.emplace_back("devices: none found");
    for (EGLint i = 0; i < count; ++i) {
      candidates.push_back(
          {"device " + std::to_string(i),
           eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)],
                                    nullptr)});
    }
  } else {
    failures.emplace_back("devices: no EGL_EXT_device_enumeration with EGL_EXT_platform_device");
  }
  candidates.push_back({"default display", eglGetDisplay(EGL_DEFAULT_DISPLAY)});
  return candidates;
}

EGLContext create_context(EGLDisplay display) {
  const std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                            4,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            5,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_CONTEXT_OPENGL_DEBUG,
#ifdef NDEBUG
                                            EGL_FALSE,
#else
                                            EGL_TRUE,
#endif
                                            EGL_NONE};
  return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
}

constexpr const char* kRemedy =
    " (install libegl1 and libgl1-mesa-dri, or trace everything: --renderer raytrace needs no "
    "OpenGL)";

// libepoxy would end the process at its first call.
void check_library() {
  void* library = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) {
    throw std::runtime_error("no OpenGL 4.5 context: libEGL.so.1 is missing" +
                             std::string(kRemedy));
  }
  dlclose(library);
}

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

EglContext::EglContext() : owner_(std::this_thread::get_id()) {
  check_library();
  std::vector<std::string> failures;
  for (const Candidate& candidate : list_displays(failures)) {
    const auto fail = [&](const std::string& what) {
      failures.push_back(candidate.platform + ": " + what + " (" + egl_error() + ")");
    };
    if (candidate.display == EGL_NO_DISPLAY) {
      fail("no display");
      continue;
    }
    if (eglInitialize(candidate.display, nullptr, nullptr) == EGL_FALSE) {
      fail("cannot be initialised");
      continue;
    }
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
      fail("has no desktop OpenGL");
      continue;
    }
    EGLContext context = create_context(candidate.display);
    if (context == EGL_NO_CONTEXT) {
      fail("no OpenGL 4.5 core context");
      continue;
    }
    if (eglMakeCurrent(candidate.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
      fail("context cannot be made current without a surface");
      eglDestroyContext(candidate.display, context);
      continue;
    }
    display_ = candidate.display;
    context_ = context;
    platform_ = candidate.platform;
    break;
  }
  if (context_ == nullptr) {
    std::string message =
        "no OpenGL 4.5 context without a window" + std::string(kRemedy) + "; tried ";
    for (std::size_t i = 0; i < failures.size(); ++i) message += (i > 0 ? "; " : "") + failures[i];
    throw std::runtime_error(message);
  }
  vendor_ = gl_string(GL_VENDOR);
  renderer_ = gl_string(GL_RENDERER);
  version_ = gl_string(GL_VERSION);
  report_gl_errors();
}

// The display stays initialised. EGL has each display once in a process, so terminating it would
// end every other context on it, and unloading Mesa's driver leaks memory.
EglContext::~EglContext() {
  check_thread();
  if (eglGetCurrentContext() == context_)
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

void EglContext::make_current() const {
  check_thread();
  if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
    throw std::runtime_error("the OpenGL context cannot be used again (" + egl_error() + ")");
  }
}

void EglContext::check_thread() const {
  AMALGAM_CHECK(std::this_thread::get_id() == owner_,
                "OpenGL used on another thread than the one that made its context");
}

}  // namespace amalgam::gl
