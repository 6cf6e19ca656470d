#include "apps/view/drawing/headless_context.h"

#include "soms/base/error.h"

#include <dlfcn.h>
#include <epoxy/egl.h>

#include <array>
#include <string>

namespace soms::view {

namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& remedy) {
  throw Error(ErrorKind::cannot_write, "EGL: " + what, remedy);
}

// epoxy ends the program where the library is missing, so that is asked first.
void check_library() {
  void* library = ::dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) {
    refuse("libEGL.so.1 is not installed, so nothing can be drawn without a screen",
           "install libegl1 and libgl1-mesa-dri");
  }
  ::dlclose(library);
}

// Displays without a screen, the ones that need least first.
EGLDisplay find_display() {
  const auto started = [](EGLDisplay display) {
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE;
  };
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base")) {
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
      std::array<EGLDeviceEXT, 8> devices{};
      EGLint count = 0;
      eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
      for (EGLint i = 0; i < count; ++i) {
        EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
        const EGLDisplay display =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
        if (started(display)) {
          return display;
        }
      }
    }
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
      const EGLDisplay display =
          eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
      if (started(display)) {
        return display;
      }
    }
  }
  refuse("no driver draws without a screen here",
         "install libgl1-mesa-dri (software) or the driver of your graphics card");
}

}  // namespace

struct HeadlessContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  ~Handles() {
    if (display != EGL_NO_DISPLAY) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      if (context != EGL_NO_CONTEXT) {
        eglDestroyContext(display, context);
      }
      eglTerminate(display);
    }
  }
};

HeadlessContext::HeadlessContext() : handles_(std::make_unique<Handles>()) {
  check_library();
  Handles& h = *handles_;
  h.display = find_display();
  const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                     EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE ||
      eglChooseConfig(h.display, wanted.data(), &config, 1, &count) != EGL_TRUE || count < 1) {
    refuse("the driver offers no desktop OpenGL", "install libgl1-mesa-dri");
  }
  const std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE};
  h.context = eglCreateContext(h.display, config, EGL_NO_CONTEXT, version.data());
  if (h.context == EGL_NO_CONTEXT) {
    refuse("the driver does not offer OpenGL 3.3",
           "update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1");
  }
  if (eglMakeCurrent(h.display, EGL_NO_SURFACE, EGL_NO_SURFACE, h.context) != EGL_TRUE) {
    refuse("the driver cannot draw without a surface", "install libgl1-mesa-dri");
  }
}

HeadlessContext::~HeadlessContext() = default;

}  // namespace soms::view
