#include "apps/view/drawing/gl/headless_context.h"

#include "soms/base/error.h"

#include <dlfcn.h>
#include <epoxy/egl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& remedy) {
  throw Error(ErrorKind::cannot_write, "EGL: " + what, remedy);
}

// epoxy ends the program where the library is missing, so that is checked first.
void check_library() {
  void* library = ::dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) {
    refuse("libEGL.so.1 is not installed, so nothing can be drawn without a screen",
           "install libegl1 and libgl1-mesa-dri");
  }
  ::dlclose(library);
}

// Displays without a screen, the ones that need least first; none is started yet.
std::vector<EGLDisplay> possible_displays() {
  std::vector<EGLDisplay> displays;
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) {
    return displays;
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
    EGLint count = 0;
    eglQueryDevicesEXT(0, nullptr, &count);
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(std::max(count, 0)));
    eglQueryDevicesEXT(count, devices.data(), &count);
    for (EGLDeviceEXT device : devices) {
      displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
    }
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    displays.push_back(
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  return displays;
}

}  // namespace

/// A started display and its context.
struct HeadlessContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  explicit Handles(EGLDisplay of) : display(of) {}

  ~Handles() {
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) {
      eglDestroyContext(display, context);
    }
    eglTerminate(display);
  }

  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  void make_context();
};

void HeadlessContext::Handles::make_context() {
  const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                     EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE ||
      eglChooseConfig(display, wanted.data(), &config, 1, &count) != EGL_TRUE || count < 1) {
    refuse("the driver offers no desktop OpenGL", "install libgl1-mesa-dri");
  }
  const std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE};
  context = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
  if (context == EGL_NO_CONTEXT) {
    refuse("the driver does not offer OpenGL 3.3",
           "update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1");
  }
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
    refuse("the driver cannot draw without a surface", "install libgl1-mesa-dri");
  }
}

HeadlessContext::HeadlessContext() {
  check_library();
  // A card whose driver offers too little may stand beside one, or beside software, that draws.
  std::optional<Error> first_fault;
  for (EGLDisplay display : possible_displays()) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
      continue;
    }
    auto started = std::make_unique<Handles>(display);
    try {
      started->make_context();
      handles_ = std::move(started);
      return;
    } catch (const Error& fault) {
      first_fault = first_fault.value_or(fault);
    }
  }
  if (first_fault) {
    throw Error(*first_fault);
  }
  refuse("no graphics driver can draw without a screen",
         "install libgl1-mesa-dri (software) or the driver of your graphics card");
}

HeadlessContext::~HeadlessContext() = default;

}  // namespace soms::view
