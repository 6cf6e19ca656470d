#include "apps/view/window/app_window.h"

#include "soms/base/error.h"

#include "apps/view/control/style.h"
#include "apps/view/window/display_loss.h"
#include "apps/view/window/glfw_input.h"
#include "apps/view/window/glfw_keys.h"
#include "apps/view/window/imgui_backends.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <variant>

namespace soms::view {

namespace {

constexpr const char* kRemedy =
    "use soms render to draw pictures without a screen; over ssh, log in with ssh -X";

/// What GLFW says of its last failure, in its words.
std::string reason() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason given" : text;
}

PixelPoint cursor(GLFWwindow* window) {
  PixelPoint at;
  glfwGetCursorPos(window, &at.x, &at.y);
  return at;
}

/// The initialized library, given back at the end.
struct Library {
  Library() {
    if (glfwInit() != GLFW_TRUE) {
      throw Error(ErrorKind::cannot_write, "cannot open a window: no display (" + reason() + ")",
                  kRemedy);
    }
  }

  ~Library() { glfwTerminate(); }

  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

GLFWwindow* open_window(const std::string& title, Size size) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  GLFWwindow* const window =
      glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
  if (window == nullptr) {
    throw Error(ErrorKind::cannot_write, "cannot open a window with OpenGL 3.3 (" + reason() + ")",
                "update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1");
  }
  return window;
}

/// Pixels of a unit of the cursor.
double pixels_of_unit(GLFWwindow* window) {
  int width = 0;
  int height = 0;
  int pixel_width = 0;
  int pixel_height = 0;
  glfwGetWindowSize(window, &width, &height);
  glfwGetFramebufferSize(window, &pixel_width, &pixel_height);
  return width > 0 && pixel_width > 0 ? static_cast<double>(pixel_width) / width : 1;
}

/// Units of the cursor that a point of text has.
double units_of_point(GLFWwindow* window) {
  float x = 1;
  float y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return std::max(1.0, static_cast<double>(std::max(x, y)) / pixels_of_unit(window));
}

}  // namespace

struct AppWindow::State {
  State(const std::string& title, Size wanted) : window(open_window(title, wanted)) {}

  ~State() { glfwDestroyWindow(window); }

  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void add(InputEvent event) {
    events.push_back(std::move(event));
    touched = true;
  }

  /// Brings an event to the panels; one that comes within a frame of theirs after it, since their
  /// keys must not change meanwhile.
  void feed(std::function<void()> event) {
    if (in_frame) {
      later.push_back(std::move(event));
    } else {
      event();
    }
  }

  static State& of(GLFWwindow* window) {
    return *static_cast<State*>(glfwGetWindowUserPointer(window));
  }

  void listen();
  void listen_to_window() const;

  Library library;
  GLFWwindow* window;
  std::vector<InputEvent> events;
  std::vector<std::function<void()>> later;  ///< for the panels
  bool in_frame = false;                     ///< of the panels
  bool touched = true;
  bool fullscreen = false;
  int left = 0;  ///< of the window before it filled the screen
  int top = 0;
  Size before;
};

void AppWindow::State::listen() {
  glfwSetWindowUserPointer(window, this);
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
    of(w).feed([=] { ImGui_ImplGlfw_KeyCallback(w, key, scancode, action, modifiers); });
    const Key known = key_of_glfw(key, glfwGetKeyName(key, scancode));
    if (known == Key::none) {
      of(w).touched = true;
    } else if (action == GLFW_RELEASE) {
      of(w).add(KeyUp{known});
    } else {
      of(w).add(KeyDown{press_of_glfw(known, modifiers), action == GLFW_REPEAT});
    }
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned int character) {
    of(w).feed([=] { ImGui_ImplGlfw_CharCallback(w, character); });
    of(w).touched = true;
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    of(w).add(MouseMove{{x, y}});
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
    of(w).feed([=] { ImGui_ImplGlfw_MouseButtonCallback(w, button, action, modifiers); });
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) {
      return;
    }
    const MouseButton known = button == GLFW_MOUSE_BUTTON_LEFT    ? MouseButton::left
                              : button == GLFW_MOUSE_BUTTON_RIGHT ? MouseButton::right
                                                                  : MouseButton::middle;
    if (action == GLFW_PRESS) {
      of(w).add(MouseDown{known, cursor(w), (modifiers & GLFW_MOD_SHIFT) != 0,
                          (modifiers & GLFW_MOD_CONTROL) != 0, glfwGetTime()});
    } else {
      of(w).add(MouseUp{known, cursor(w)});
    }
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    of(w).feed([=] { ImGui_ImplGlfw_ScrollCallback(w, x, y); });
    of(w).add(Wheel{y, cursor(w)});
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    for (int i = 0; i < count; ++i) {
      of(w).add(FileDropped{paths[i]});
    }
  });
  listen_to_window();
}

void AppWindow::State::listen_to_window() const {
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    of(w).feed([=] { ImGui_ImplGlfw_WindowFocusCallback(w, focused); });
    if (focused == GLFW_FALSE) {
      of(w).add(FocusLost{});
    }
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    of(w).feed([=] { ImGui_ImplGlfw_CursorEnterCallback(w, entered); });
    of(w).touched = true;
  });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).touched = true; });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).touched = true; });
  glfwSetWindowCloseCallback(window, [](GLFWwindow* w) { of(w).touched = true; });
}

AppWindow::AppWindow(const std::string& title, Size size)
    : state_(std::make_unique<State>(title, size)) {
  end_when_the_display_is_lost();
  glfwMakeContextCurrent(state_->window);
  glfwSwapInterval(1);
  state_->listen();
  ImGui::CreateContext();
  set_style(point());
  ImGui_ImplGlfw_InitForOpenGL(state_->window, false);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

AppWindow::~AppWindow() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void AppWindow::wait(double seconds) {
  if (seconds < 0) {
    glfwWaitEvents();
  } else if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
}

void AppWindow::wake() {
  glfwPostEmptyEvent();
}

std::vector<InputEvent> AppWindow::take_events(bool& touched) {
  touched = std::exchange(state_->touched, false);
  return std::exchange(state_->events, {});
}

bool AppWindow::wants_answer() const {
  glfwPollEvents();
  return close_requested() ||
         std::any_of(state_->events.begin(), state_->events.end(), [](const InputEvent& event) {
           return std::holds_alternative<KeyDown>(event) ||
                  std::holds_alternative<MouseDown>(event) ||
                  std::holds_alternative<Wheel>(event) ||
                  std::holds_alternative<FileDropped>(event);
         });
}

bool AppWindow::close_requested() const {
  return glfwWindowShouldClose(state_->window) == GLFW_TRUE;
}

Size AppWindow::size() const {
  Size size;
  glfwGetWindowSize(state_->window, &size.width, &size.height);
  return size;
}

Size AppWindow::pixels() const {
  Size size;
  glfwGetFramebufferSize(state_->window, &size.width, &size.height);
  return size;
}

double AppWindow::point() const {
  return units_of_point(state_->window);
}

double AppWindow::density() const {
  return point() * pixels_of_unit(state_->window);
}

void AppWindow::clear() {
  const ImVec4& color = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  glClearColor(color.x, color.y, color.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

void AppWindow::begin_panels() {
  state_->in_frame = true;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void AppWindow::end_panels() {
  ImGui::Render();
  state_->in_frame = false;
  for (const auto& event : std::exchange(state_->later, {})) {
    event();
  }
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

Picture AppWindow::read_pixels() const {
  const Size size = pixels();
  const auto row = static_cast<std::size_t>(size.width) * 4;
  const auto rows = static_cast<std::size_t>(size.height);
  std::vector<std::uint8_t> upward(row * rows);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
  Picture picture{size, {}};
  picture.bytes.reserve(upward.size());
  for (std::size_t y = rows; y-- > 0;) {
    const auto first = upward.begin() + static_cast<std::ptrdiff_t>(y * row);
    picture.bytes.insert(picture.bytes.end(), first, first + static_cast<std::ptrdiff_t>(row));
  }
  for (std::size_t i = 3; i < picture.bytes.size(); i += 4) {
    picture.bytes[i] = 255;  // what the window system would blend with is not part of the picture
  }
  return picture;
}

void AppWindow::finish() {
  glFinish();
}

void AppWindow::show() {
  glfwSwapBuffers(state_->window);
}

void AppWindow::hide() {
  glfwHideWindow(state_->window);
}

void AppWindow::set_title(const std::string& title) {
  glfwSetWindowTitle(state_->window, title.c_str());
}

void AppWindow::toggle_fullscreen() {
  State& s = *state_;
  s.touched = true;
  if (s.fullscreen) {
    glfwSetWindowMonitor(s.window, nullptr, s.left, s.top, s.before.width, s.before.height,
                         GLFW_DONT_CARE);
    s.fullscreen = false;
    return;
  }
  GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* const mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
  if (mode == nullptr) {
    return;
  }
  glfwGetWindowPos(s.window, &s.left, &s.top);
  s.before = size();
  glfwSetWindowMonitor(s.window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  s.fullscreen = true;
}

}  // namespace soms::view
