#include "apps/view/window/display_loss.h"

#include <dlfcn.h>
#include <unistd.h>

#include <string_view>

namespace soms::view {

namespace {

constexpr int kCannotWrite = 5;

/// Called by Xlib, in the middle of anything: no more than a write and the end.
int on_loss(void* /*display*/) {
  constexpr std::string_view kText =
      "soms-view: the display was lost; start the viewer again when it is back\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kText.data(), kText.size());
  ::_exit(kCannotWrite);
}

}  // namespace

void end_when_the_display_is_lost() {
  // GLFW brought Xlib in, or did not; asking for its function by name spares a dependency on it.
  using Handler = int (*)(void*);
  using Setter = Handler (*)(Handler);
  void* const found = ::dlsym(RTLD_DEFAULT, "XSetIOErrorHandler");
  if (found != nullptr) {
    reinterpret_cast<Setter>(found)(on_loss);
  }
}

}  // namespace soms::view
